// The lamp on the dock: lit while the robot charges, blinking while the bumper is pressed.

#include <ros/ros.h>
#include <std_msgs/Bool.h>

namespace
{

bool g_charging = false;
bool g_alarm = false;
bool g_lit = false;

void chargingCallback(const std_msgs::Bool& msg)
{
  g_charging = msg.data;
}

void bumperCallback(const std_msgs::Bool& msg)
{
  g_alarm = msg.data;
}

}  // namespace

int main(int argc, char** argv)
{
  ros::init(argc, argv, "dock_lamp");
  ros::NodeHandle nh;
  ros::Publisher lamp = nh.advertise<std_msgs::Bool>("lamp", 1);
  ros::Subscriber charging = nh.subscribe("charging", 1, chargingCallback);
  ros::Subscriber bumper = nh.subscribe("bumper", 1, bumperCallback);

  ros::Rate rate(2);
  while (ros::ok())
  {
    ros::spinOnce();
    if (g_alarm || g_charging != g_lit)
    {
      g_lit = !g_lit;
      std_msgs::Bool msg;
      msg.data = g_lit;
      lamp.publish(msg);
    }
    rate.sleep();
  }
  return 0;
}
