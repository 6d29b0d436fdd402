#ifndef BASE_COMMON_STATUS_REPORTER_H
#define BASE_COMMON_STATUS_REPORTER_H

#include <string>

#include <base_msgs/BaseStatus.h>
#include <ros/ros.h>

namespace base_common
{
/// Publishes the state of a node on "<node>/status": whenever it changes, and once per second.
class StatusReporter
{
public:
  explicit StatusReporter(ros::NodeHandle& private_nh, const std::string& topic = "status");

  void report(uint8_t level, const std::string& text);

private:
  void repeat(const ros::TimerEvent& event);

  ros::Publisher pub_;
  ros::Timer timer_;
  base_msgs::BaseStatus status_;
};
}  // namespace base_common

#endif
