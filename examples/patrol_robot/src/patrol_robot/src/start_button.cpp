#include <ros/ros.h>
#include <sensor_msgs/Joy.h>
#include <std_srvs/SetBool.h>

// A button of the joystick starts the patrol, another one ends it.
ros::ServiceClient g_enable;
int g_start_button = 0;
int g_stop_button = 1;

void onJoystick(const sensor_msgs::Joy::ConstPtr& joy)
{
  std_srvs::SetBool request;
  request.request.data = joy->buttons[g_start_button];
  if (joy->buttons[g_start_button] || joy->buttons[g_stop_button])
    g_enable.call(request);
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "start_button");
  ros::NodeHandle nh;
  ros::param::param("~start_button", g_start_button, 0);
  ros::param::param("~stop_button", g_stop_button, 1);
  g_enable = nh.serviceClient<std_srvs::SetBool>("patrol/enable");
  ros::Subscriber joystick = nh.subscribe("joy", 1, onJoystick);
  ros::spin();
  return 0;
}
