// Subscribers of image_transport and message_filters that feed filters, of ROS 1: the third argument is the queue.
//
// expect: subscriber left sensor_msgs/Image queue=4 callback=onImage via=image_transport
// expect: subscriber right sensor_msgs/Image queue=2 callback=onImage via=image_transport
// expect-only: subscriber
#include <image_transport/image_transport.h>
#include <image_transport/subscriber_filter.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void onImage(const sensor_msgs::ImageConstPtr &) {}

int main(int argc, char ** argv)
{
  ros::init(argc, argv, "eyes");
  ros::NodeHandle nh;
  image_transport::ImageTransport transport(nh);
  image_transport::SubscriberFilter left(transport, "left", 4);
  left.registerCallback(onImage);
  image_transport::SubscriberFilter right;
  right.subscribe(transport, "right", 2, image_transport::TransportHints("raw"));
  right.registerCallback(onImage);
  ros::spin();
}
