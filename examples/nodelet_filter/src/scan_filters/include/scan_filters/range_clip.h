#ifndef SCAN_FILTERS_RANGE_CLIP_H
#define SCAN_FILTERS_RANGE_CLIP_H

#include <scan_filters/filter_base.h>
#include <std_msgs/UInt32.h>

namespace scan_filters
{
class RangeClip : public FilterBase
{
protected:
  void configure(ros::NodeHandle& private_nh) override;
  bool filter(sensor_msgs::LaserScan& scan) override;

private:
  float min_range_;
  float max_range_;
  ros::Publisher dropped_pub_;
};
}  // namespace scan_filters

#endif
