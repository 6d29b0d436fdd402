#include <scan_filters/range_clip.h>

#include <limits>

#include <pluginlib/class_list_macros.h>

namespace scan_filters
{
void RangeClip::configure(ros::NodeHandle& private_nh)
{
  min_range_ = private_nh.param("min_range", 0.1f);
  max_range_ = private_nh.param("max_range", 30.0f);
  if (min_range_ >= max_range_)
    NODELET_WARN("min_range is not below max_range, all readings will be dropped");
  dropped_pub_ = private_nh.advertise<std_msgs::UInt32>("dropped", 1, true);
}

bool RangeClip::filter(sensor_msgs::LaserScan& scan)
{
  std_msgs::UInt32 dropped;
  for (float& range : scan.ranges)
  {
    if (range < min_range_ || range > max_range_)
    {
      range = std::numeric_limits<float>::quiet_NaN();
      ++dropped.data;
    }
  }
  if (dropped.data > 0)
    dropped_pub_.publish(dropped);
  return dropped.data < scan.ranges.size();
}
}  // namespace scan_filters

PLUGINLIB_EXPORT_CLASS(scan_filters::RangeClip, nodelet::Nodelet)
