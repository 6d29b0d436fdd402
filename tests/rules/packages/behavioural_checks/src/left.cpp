// Serves `left` only when `right` is there, which only comes after `left`.
// expect: service_server left
// expect-not: port_quality_given(_, _, _)
#include <ros/ros.h>
#include <std_srvs/Empty.h>

bool onLeft(std_srvs::Empty::Request&, std_srvs::Empty::Response&) { return true; }

int main(int argc, char** argv) {
  ros::init(argc, argv, "left");
  ros::NodeHandle nh;
  ros::ServiceServer early = nh.advertiseService("early", onLeft);
  ros::ServiceClient client = nh.serviceClient<std_srvs::Empty>("right");
  client.waitForExistence();
  ros::ServiceServer server = nh.advertiseService("left", onLeft);
  ros::spin();
}
