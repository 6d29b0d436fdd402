#include <base_common/status_reporter.h>

namespace base_common
{
StatusReporter::StatusReporter(ros::NodeHandle& private_nh, const std::string& topic)
{
  const bool latch = true;
  pub_ = private_nh.advertise<base_msgs::BaseStatus>(topic, 1, latch);
  timer_ = private_nh.createTimer(ros::Duration(1.0), &StatusReporter::repeat, this);
  status_.source = ros::this_node::getName();
}

void StatusReporter::report(uint8_t level, const std::string& text)
{
  if (level == status_.level && text == status_.text)
    return;
  status_.level = level;
  status_.text = text;
  status_.header.stamp = ros::Time::now();
  pub_.publish(status_);
}

void StatusReporter::repeat(const ros::TimerEvent&)
{
  status_.header.stamp = ros::Time::now();
  pub_.publish(status_);
}
}  // namespace base_common
