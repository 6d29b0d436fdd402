// A loop that main leaves when something has arrived is a part of the start: what follows it still initialises. A loop that spins, or acts, is not.
#include <ros/ros.h>
#include <std_msgs/Int32.h>
#include <tf/transform_listener.h>

ros::Publisher out;
int mode = 0, limit = 1;
bool stopped = false;

void awaitTransform(tf::StampedTransform& transform)
{
  static tf::TransformListener listener;
  while (true)
  {
    try
    {
      listener.lookupTransform("map", "world", ros::Time(0), transform);
      break;
    }
    catch (tf::TransformException& ex)
    {
      ros::Duration(1.0).sleep();
    }
  }
}
void onValue(const std_msgs::Int32& m)
{
  if (stopped || m.data > limit || mode == 2)
    return;
  out.publish(m);
}
void onMode(const std_msgs::Int32& m) { mode = m.data; }

int main(int argc, char** argv)
{
  ros::init(argc, argv, "n");
  ros::NodeHandle nh;
  tf::StampedTransform transform;
  awaitTransform(transform);
  limit = 5;
  mode = 1;
  out = nh.advertise<std_msgs::Int32>("out", 1);
  ros::Subscriber s1 = nh.subscribe("value", 1, onValue);
  ros::Subscriber s2 = nh.subscribe("mode", 1, onMode);
  while (ros::ok())
  {
    ros::spinOnce();
    if (mode == 3)
      break;
  }
  stopped = true;
  ros::spin();
}
// expect: periodic sleep 1.0 None  []
// expect: reactive value -> out may [!(stopped || m.data > limit || mode == 2)]
// expect: config ::limit = 5 None
// expect: state ::mode = 1
// expect: state ::stopped = false
// expect: transition ::mode . None on mode [] := m.data
// expect: transition ::stopped . None on main [] := true
