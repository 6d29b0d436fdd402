// State that a parameter gives its first value, and nothing else.
// expect: begins_with_value_of Gate::by_parameter_ ~by_parameter
#include <ros/ros.h>
#include <std_msgs/Bool.h>
class Gate {
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  ros::Subscriber sub_;
  bool by_parameter_ = true, then_set_ = true, perhaps_ = true;

public:
  Gate() {
    ros::NodeHandle own("~");
    own.getParam("by_parameter", by_parameter_);
    own.getParam("then_set", then_set_);
    then_set_ = false;
    if (by_parameter_) own.getParam("perhaps", perhaps_);
    pub_ = nh_.advertise<std_msgs::Bool>("out", 1);
    sub_ = nh_.subscribe("in", 1, &Gate::onIn, this);
  }
  void onIn(const std_msgs::Bool& msg) {
    if (by_parameter_ && then_set_ && perhaps_) pub_.publish(msg);
    by_parameter_ = then_set_ = perhaps_ = msg.data;
  }
};
int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  Gate gate;
  ros::spin();
}
