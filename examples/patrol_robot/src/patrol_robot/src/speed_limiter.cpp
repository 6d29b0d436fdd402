#include <geometry_msgs/Twist.h>
#include <nodelet/nodelet.h>
#include <pluginlib/class_list_macros.h>
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>

#include <algorithm>

namespace patrol_robot
{
class SpeedLimiter : public nodelet::Nodelet
{
private:
  void onInit() override
  {
    ros::NodeHandle& nh = getNodeHandle();
    getPrivateNodeHandle().param("stop_distance", stop_distance_, 0.5);
    command_pub_ = nh.advertise<geometry_msgs::Twist>("cmd_vel_out", 1);
    command_sub_ = nh.subscribe("cmd_vel_in", 1, &SpeedLimiter::onCommand, this);
    scan_sub_ = nh.subscribe("scan", 1, &SpeedLimiter::onScan, this);
  }

  void onScan(const sensor_msgs::LaserScan::ConstPtr& scan)
  {
    nearest_ = scan->range_max;
    for (const float range : scan->ranges)
      if (range > scan->range_min)
        nearest_ = std::min(nearest_, range);
  }

  void onCommand(const geometry_msgs::Twist::ConstPtr& command)
  {
    geometry_msgs::Twist limited = *command;
    if (nearest_ < stop_distance_)
      limited.linear.x = std::min(limited.linear.x, 0.0);
    command_pub_.publish(limited);
  }

  ros::Publisher command_pub_;
  ros::Subscriber command_sub_;
  ros::Subscriber scan_sub_;
  double stop_distance_ = 0.5;
  float nearest_ = 0.0;
};
}  // namespace patrol_robot

PLUGINLIB_EXPORT_CLASS(patrol_robot::SpeedLimiter, nodelet::Nodelet)
