// Waits in a constructor; the server that is made before the wait keeps nobody waiting.
// expect-not: finding circular-wait "*early*"
#include <ros/ros.h>
#include <std_srvs/Empty.h>

class Right {
 public:
  Right() : client_(nh_.serviceClient<std_srvs::Empty>("left")), early_(nh_.serviceClient<std_srvs::Empty>("early")) {  // expect: finding circular-wait "/right waits for /left, which /left provides only after it has received /right, and so on in a circle"
    early_.waitForExistence();
    while (ros::ok() && !client_.waitForExistence(ros::Duration(1.0))) ROS_INFO("no left yet");
  }
  void serve() { server_ = nh_.advertiseService("right", &Right::onRight, this); }

 private:
  bool onRight(std_srvs::Empty::Request&, std_srvs::Empty::Response&) { return true; }

  ros::NodeHandle nh_;
  ros::ServiceClient client_, early_;
  ros::ServiceServer server_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "right");
  Right right;
  right.serve();
  ros::spin();
}
