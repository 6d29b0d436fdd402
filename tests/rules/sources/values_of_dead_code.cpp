// What never runs gives no values.
//
// expect: publisher kept
// expect: publisher kept_field
// expect-only: publisher
#include <ros/ros.h>
#include <std_msgs/String.h>

class Sender {
 public:
  explicit Sender(ros::NodeHandle& nh) {
    if (false)
      name_ = "never_field";
    else
      name_ = "kept_field";
    start(nh);
  }

 private:
  void start(ros::NodeHandle& nh) { pub_ = nh.advertise<std_msgs::String>(name_, 1); }
  std::string name_;
  ros::Publisher pub_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "sender");
  ros::NodeHandle nh;
  std::string topic;
  if (false)
    topic = "never";
  else
    topic = "kept";
  ros::Publisher pub = nh.advertise<std_msgs::String>(topic, 1);
  Sender sender(nh);
  ros::spin();
}
