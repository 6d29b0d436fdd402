#include <boost/make_shared.hpp>
#include <message_filters/cache.h>
#include <message_filters/chain.h>
#include <message_filters/pass_through.h>
#include <message_filters/subscriber.h>
#include <message_filters/sync_policies/approximate_time.h>
#include <message_filters/sync_policies/exact_time.h>
#include <message_filters/synchronizer.h>
#include <message_filters/time_sequencer.h>
#include <message_filters/time_synchronizer.h>
#include <ros/ros.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/Imu.h>
#include <sensor_msgs/LaserScan.h>

typedef message_filters::sync_policies::ApproximateTime<sensor_msgs::Image, sensor_msgs::Imu> Near;
typedef message_filters::sync_policies::ExactTime<sensor_msgs::Image, sensor_msgs::CameraInfo> Same;

namespace
{
void onScan(const sensor_msgs::LaserScanConstPtr&)
{
}

void onSorted(const sensor_msgs::ImuConstPtr&)
{
}

void onCached(const sensor_msgs::ImuConstPtr&)
{
}

void onPassed(const sensor_msgs::ImuConstPtr&)
{
}

void onChained(const sensor_msgs::ImuConstPtr&)
{
}
}  // namespace

class Aligner
{
public:
  Aligner() : image_(nh_, "image", 1), near_(Near(10), image_, imu_)
  {
    imu_.subscribe(nh_, "imu", 50, ros::TransportHints().tcpNoDelay());
    near_.registerCallback(boost::bind(&Aligner::onNear, this, _1, _2));

    rect_.reset(new message_filters::Subscriber<sensor_msgs::Image>(nh_, "rect", 3));
    info_.reset(new message_filters::Subscriber<sensor_msgs::CameraInfo>(nh_, "info", 4));
    same_ = boost::make_shared<message_filters::Synchronizer<Same> >(Same(5));
    same_->connectInput(*rect_, *info_);
    same_->registerCallback(&Aligner::onSame, this);
  }

private:
  void onNear(const sensor_msgs::ImageConstPtr&, const sensor_msgs::ImuConstPtr&)
  {
  }

  void onSame(const sensor_msgs::ImageConstPtr&, const sensor_msgs::CameraInfoConstPtr&)
  {
  }

  ros::NodeHandle nh_;
  message_filters::Subscriber<sensor_msgs::Image> image_;
  message_filters::Subscriber<sensor_msgs::Imu> imu_;
  message_filters::Synchronizer<Near> near_;
  boost::shared_ptr<message_filters::Subscriber<sensor_msgs::Image> > rect_;
  boost::shared_ptr<message_filters::Subscriber<sensor_msgs::CameraInfo> > info_;
  boost::shared_ptr<message_filters::Synchronizer<Same> > same_;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "aligner");
  ros::NodeHandle nh;
  Aligner aligner;

  message_filters::Subscriber<sensor_msgs::LaserScan> scan(nh, "scan", 2);
  scan.registerCallback(onScan);

  message_filters::Subscriber<sensor_msgs::Imu> late(nh, "imu/late", 20);
  message_filters::TimeSequencer<sensor_msgs::Imu> sequencer(late, ros::Duration(0.1), ros::Duration(0.01), 10);
  sequencer.registerCallback(onSorted);

  message_filters::Subscriber<sensor_msgs::Imu> recent(nh, "imu/recent", 21);
  message_filters::Cache<sensor_msgs::Imu> cache(recent, 100);
  cache.registerCallback(onCached);

  message_filters::Subscriber<sensor_msgs::Imu> plain(nh, "imu/plain", 22);
  message_filters::PassThrough<sensor_msgs::Imu> pass(plain);
  pass.registerCallback(onPassed);

  message_filters::Chain<sensor_msgs::Imu> chain;
  chain.addFilter(boost::shared_ptr<message_filters::Subscriber<sensor_msgs::Imu> >(new message_filters::Subscriber<sensor_msgs::Imu>(nh, "imu/chained", 23)));
  chain.addFilter(boost::make_shared<message_filters::TimeSequencer<sensor_msgs::Imu> >(ros::Duration(0.2), ros::Duration(0.01), 10));
  chain.registerCallback(onChained);

  // a subscriber without a topic does not subscribe
  message_filters::Subscriber<sensor_msgs::Imu> later(nh, "", 24);

  ros::spin();
  return 0;
}
