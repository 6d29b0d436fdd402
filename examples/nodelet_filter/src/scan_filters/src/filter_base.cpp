#include <scan_filters/filter_base.h>

#include <boost/make_shared.hpp>

namespace scan_filters
{
void FilterBase::onInit()
{
  ros::NodeHandle& nh = getNodeHandle();
  ros::NodeHandle& private_nh = getPrivateNodeHandle();
  configure(private_nh);

  int queue_size;
  private_nh.param("queue_size", queue_size, 5);
  pub_ = nh.advertise<sensor_msgs::LaserScan>("scan_out", 5);
  sub_ = nh.subscribe("scan_in", queue_size, &FilterBase::onScan, this);
}

void FilterBase::onScan(const sensor_msgs::LaserScan::ConstPtr& scan)
{
  auto changed = boost::make_shared<sensor_msgs::LaserScan>(*scan);
  if (filter(*changed))
    pub_.publish(changed);
}
}  // namespace scan_filters
