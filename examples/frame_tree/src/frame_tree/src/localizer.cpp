#include <string>

#include <geometry_msgs/PoseStamped.h>
#include <message_filters/subscriber.h>
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>
#include <tf/message_filter.h>
#include <tf/transform_broadcaster.h>
#include <tf/transform_listener.h>

class Localizer
{
public:
  Localizer() : private_nh_("~"), scans_(nh_, "scan", 10), filter_(scans_, listener_, "odom", 10)
  {
    private_nh_.param<std::string>("base_frame", base_frame_, "base_link");
    filter_.registerCallback(boost::bind(&Localizer::onScan, this, _1));
  }

private:
  void onScan(const sensor_msgs::LaserScanConstPtr& scan)
  {
    tf::StampedTransform odom;
    if (!listener_.waitForTransform("odom", base_frame_, scan->header.stamp, ros::Duration(0.1)))
    {
      return;
    }
    listener_.lookupTransform("odom", base_frame_, scan->header.stamp, odom);
    broadcaster_.sendTransform(tf::StampedTransform(odom.inverse(), scan->header.stamp, "map", "odom"));
  }

  ros::NodeHandle nh_, private_nh_;
  tf::TransformListener listener_;
  tf::TransformBroadcaster broadcaster_;
  message_filters::Subscriber<sensor_msgs::LaserScan> scans_;
  tf::MessageFilter<sensor_msgs::LaserScan> filter_;
  std::string base_frame_;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "localizer");
  Localizer localizer;
  ros::spin();
  return 0;
}
