#ifndef SCAN_FILTERS_FILTER_BASE_H
#define SCAN_FILTERS_FILTER_BASE_H

#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>

namespace scan_filters
{
/// A nodelet that turns each scan into at most one other.
class FilterBase : public nodelet::Nodelet
{
protected:
  void onInit() override;

  /// Reads the parameters of the filter.
  virtual void configure(ros::NodeHandle& private_nh) = 0;

  /// Changes the scan in place; false drops it.
  virtual bool filter(sensor_msgs::LaserScan& scan) = 0;

  ros::Publisher pub_;
  ros::Subscriber sub_;

private:
  void onScan(const sensor_msgs::LaserScan::ConstPtr& scan);
};
}  // namespace scan_filters

#endif
