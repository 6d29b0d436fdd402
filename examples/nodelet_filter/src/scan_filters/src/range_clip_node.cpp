// The nodelet range_clip as a node of its own, for robots without a nodelet manager.
#include <nodelet/loader.h>
#include <ros/ros.h>
#include <std_msgs/String.h>

int main(int argc, char** argv)
{
  ros::init(argc, argv, "range_clip");

  nodelet::Loader loader;
  nodelet::M_string remappings(ros::names::getRemappings());
  nodelet::V_string arguments(argv + 1, argv + argc);
  if (!loader.load(ros::this_node::getName(), "scan_filters/range_clip", remappings, arguments))
  {
    ROS_FATAL("cannot load the nodelet");
    return 1;
  }

  ros::NodeHandle nh;
  ros::Publisher mode_pub = nh.advertise<std_msgs::String>(ros::this_node::getName() + "/mode", 1, true);
  std_msgs::String mode;
  mode.data = "standalone";
  mode_pub.publish(mode);

  ros::spin();
  return 0;
}
