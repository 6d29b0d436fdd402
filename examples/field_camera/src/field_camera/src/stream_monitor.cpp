#include <string>

#include <image_transport/image_transport.h>
#include <image_transport/subscriber_filter.h>
#include <message_filters/time_synchronizer.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class StreamMonitor
{
public:
  StreamMonitor()
    : transport_(nh_), left_(transport_, "left/image_rect", 3), stereo_(10)
  {
    const image_transport::TransportHints hints("compressed");
    overview_ = transport_.subscribe("overview/image", 1, &StreamMonitor::onOverview, this, hints);
    camera_ = transport_.subscribeCamera("camera/image_raw", 5, &StreamMonitor::onCamera, this);
    right_.subscribe(transport_, "right/image_rect", 4);
    stereo_.connectInput(left_, right_);
    stereo_.registerCallback(boost::bind(&StreamMonitor::onPair, this, _1, _2));
  }

private:
  void onOverview(const sensor_msgs::ImageConstPtr&)
  {
    ++frames_;
  }

  void onCamera(const sensor_msgs::ImageConstPtr&, const sensor_msgs::CameraInfoConstPtr&)
  {
    ++frames_;
  }

  void onPair(const sensor_msgs::ImageConstPtr&, const sensor_msgs::ImageConstPtr&)
  {
    ++frames_;
  }

  ros::NodeHandle nh_;
  image_transport::ImageTransport transport_;
  image_transport::Subscriber overview_;
  image_transport::CameraSubscriber camera_;
  image_transport::SubscriberFilter left_, right_;
  message_filters::TimeSynchronizer<sensor_msgs::Image, sensor_msgs::Image> stereo_;
  unsigned frames_ = 0;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "stream_monitor");
  StreamMonitor monitor;
  ros::spin();
  return 0;
}
