// A condition that is tested again, deeper: what holds above cannot fail below, unless something is changed between, or another variable is called so.
#include <ros/ros.h>
#include <std_msgs/Int32.h>

ros::Publisher pub, bell, lamp;
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


// each has a switch of its own
struct Lamp
{
  bool enabled_ = false;
  void onEnable(const std_msgs::Int32& m) { enabled_ = m.data > 0; }
  void shine(const std_msgs::Int32& m)
  {
    if (enabled_)
      lamp.publish(m);
  }
};
struct Keeper
{
  Lamp lamp_;
  bool enabled_ = true;
  void onEnable(const std_msgs::Int32& m) { enabled_ = m.data > 0; }
  void onDusk(const std_msgs::Int32& m)
  {
    if (enabled_)
      return;
    lamp_.shine(m);
  }
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "n");
  ros::NodeHandle nh;
  pub = nh.advertise<std_msgs::Int32>("out", 1);
  bell = nh.advertise<std_msgs::Int32>("bell", 1);
  ros::Subscriber s1 = nh.subscribe("map", 1, onMap);
  ros::Subscriber s2 = nh.subscribe("goal", 1, onGoal);
  ros::Subscriber s3 = nh.subscribe("arm", 1, onArm);
  lamp = nh.advertise<std_msgs::Int32>("lamp", 1);
  Keeper keeper;
  ros::Subscriber s4 = nh.subscribe("dusk", 1, &Keeper::onDusk, &keeper);
  ros::Subscriber s5 = nh.subscribe("keep", 1, &Keeper::onEnable, &keeper);
  ros::Subscriber s6 = nh.subscribe("light", 1, &Lamp::onEnable, &keeper.lamp_);
  ros::spin();
}
// expect: reactive goal -> out may [!(map_size == 0)]
// expect: reactive arm -> bell may [!armed && armed]
// expect: reactive dusk -> lamp may [!enabled_ && enabled_]
// expect: state ::armed = false
// expect: state Keeper::enabled_ = true
// expect: state Lamp::enabled_ = false
// expect: transition Keeper::enabled_ . None on keep [] := m.data > 0
// expect: transition Lamp::enabled_ . None on light [] := m.data > 0
// expect: state ::map_size = 0
// expect: transition ::armed . None on arm [!armed] := true
// expect: transition ::map_size . None on map [] := m.data
