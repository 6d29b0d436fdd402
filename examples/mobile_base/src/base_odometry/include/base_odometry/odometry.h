#ifndef BASE_ODOMETRY_ODOMETRY_H
#define BASE_ODOMETRY_ODOMETRY_H

#include <string>

#include <base_common/status_reporter.h>
#include <base_msgs/WheelTicks.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>
#include <tf2_ros/transform_broadcaster.h>

namespace base_odometry
{
class Odometry
{
public:
  Odometry(ros::NodeHandle nh, ros::NodeHandle private_nh);

private:
  void loadParameters(const ros::NodeHandle& private_nh);
  void onTicks(const base_msgs::WheelTicksConstPtr& ticks);
  bool onReset(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  void publish(const ros::Time& stamp);

  template <class Message>
  ros::Publisher advertise(ros::NodeHandle& nh, const std::string& topic)
  {
    return nh.advertise<Message>(topic, queue_size_);
  }

  static constexpr int queue_size_ = 20;

  base_common::StatusReporter status_;
  tf2_ros::TransformBroadcaster broadcaster_;
  ros::Publisher odom_pub_;
  ros::Subscriber ticks_sub_;
  ros::ServiceServer reset_server_;

  std::string odom_topic_;
  std::string odom_frame_;
  std::string base_frame_;
  double ticks_per_meter_ = 4000.0;
  bool publish_tf_ = true;

  base_msgs::WheelTicks last_ticks_;
  bool has_ticks_ = false;
  nav_msgs::Odometry odom_;
};
}  // namespace base_odometry

#endif
