// A condition that is tested again, deeper: what holds above cannot fail below, unless something is changed between.
#include <ros/ros.h>
#include <std_msgs/Int32.h>

ros::Publisher pub, bell;
int map_size = 0;
bool armed = false;

void plan(const std_msgs::Int32& m)
{
  if (map_size == 0)
  {
    bell.publish(m);
    return;
  }
  pub.publish(m);
}
void onMap(const std_msgs::Int32& m) { map_size = m.data; }
void onGoal(const std_msgs::Int32& m)
{
  if (map_size == 0)
    return;
  plan(m);
}
void fire(const std_msgs::Int32& m)
{
  if (armed)
    bell.publish(m);
}
void onArm(const std_msgs::Int32& m)
{
  if (!armed)
  {
    armed = true;
    fire(m);
  }
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "n");
  ros::NodeHandle nh;
  pub = nh.advertise<std_msgs::Int32>("out", 1);
  bell = nh.advertise<std_msgs::Int32>("bell", 1);
  ros::Subscriber s1 = nh.subscribe("map", 1, onMap);
  ros::Subscriber s2 = nh.subscribe("goal", 1, onGoal);
  ros::Subscriber s3 = nh.subscribe("arm", 1, onArm);
  ros::spin();
}
// expect: reactive goal -> out may [!(map_size == 0)]
// expect: reactive arm -> bell may [!armed && armed]
// expect: state ::armed = false
// expect: state ::map_size = 0
// expect: transition ::armed . None on arm [!armed] := true
// expect: transition ::map_size . None on map [] := m.data
