// Transports that subscribers of images ask for.
//
// expect: asks_transport([_, _, "front"], "compressed")
// expect: asks_transport([_, _, "back"], "theora")
// expect: 2 = count : { asks_transport(_, _) }
#include <image_transport/image_transport.h>
#include <ros/ros.h>

void onImage(const sensor_msgs::ImageConstPtr&) {}

int main(int argc, char** argv) {
  ros::init(argc, argv, "view");
  ros::NodeHandle nh;
  image_transport::ImageTransport it(nh);
  image_transport::TransportHints hints("theora");
  image_transport::Subscriber front = it.subscribe("front", 1, onImage, ros::VoidPtr(), image_transport::TransportHints("compressed"));
  image_transport::Subscriber back = it.subscribe("back", 1, onImage, ros::VoidPtr(), hints);
  image_transport::Subscriber plain = it.subscribe("plain", 1, onImage);
  ros::spin();
}
