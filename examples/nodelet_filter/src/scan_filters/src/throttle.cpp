#include <scan_filters/filter_base.h>

#include <pluginlib/class_list_macros.h>
#include <std_msgs/Empty.h>

namespace scan_filters
{
/// Passes on every n-th scan, and the next one when asked to.
class Throttle : public FilterBase
{
protected:
  void configure(ros::NodeHandle& private_nh) override
  {
    private_nh.getParam("keep_every", keep_every_);
    trigger_sub_ = private_nh.subscribe("trigger", 1, &Throttle::onTrigger, this);
  }

  bool filter(sensor_msgs::LaserScan&) override
  {
    if (pub_.getNumSubscribers() == 0)
      return false;
    if (++seen_ < keep_every_ && !triggered_)
      return false;
    seen_ = 0;
    triggered_ = false;
    return true;
  }

private:
  void onTrigger(const std_msgs::EmptyConstPtr&)
  {
    triggered_ = true;
  }

  ros::Subscriber trigger_sub_;
  int keep_every_ = 10;
  int seen_ = 0;
  bool triggered_ = false;
};
}  // namespace scan_filters

PLUGINLIB_EXPORT_CLASS(scan_filters::Throttle, nodelet::Nodelet)
