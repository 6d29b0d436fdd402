// a second thread serves
#include <ros/ros.h>
#include <std_msgs/String.h>
#include <std_srvs/Empty.h>

ros::ServiceClient client, other;

bool onReset(std_srvs::Empty::Request&, std_srvs::Empty::Response&) { return true; }
void onGo(const std_msgs::String&) {
  std_srvs::Empty call;
  client.call(call);
  other.call(call);
}

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  client = nh.serviceClient<std_srvs::Empty>("/reset");
  other = nh.serviceClient<std_srvs::Empty>("/other");
  ros::ServiceServer server = nh.advertiseService("/reset", onReset);
  ros::Subscriber sub = nh.subscribe("/go", 1, onGo);
  ros::AsyncSpinner spinner(2);
  spinner.start();
  ros::waitForShutdown();
}
