// What the start gives a variable under a condition, or by a function that also runs later, may be what it begins with, or may not.
// expect: state Gate::by_condition_ = None
// expect: state Gate::by_helper_ = None
// expect: state Gate::by_argument_ = None
// expect: state Gate::same_ = false
// expect: reactive in -> out may [by_condition_ && by_helper_ && by_argument_ && !same_]
// expect: transition Gate::by_condition_ . None on in [] := msg.data
// expect: transition Gate::by_helper_ . None on in [] := true
// expect: transition Gate::by_argument_ . None on in [] := value
// expect: transition Gate::same_ . None on in [] := false
// expect: transition Gate::same_ . None on set [] := msg.data
#include <ros/ros.h>
#include <std_msgs/Bool.h>
class Gate {
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  ros::Subscriber sub_, set_;
  bool by_condition_ = false, by_helper_ = false, by_argument_ = false, same_ = false;

  void enable() { by_helper_ = true; }
  void set(bool value) { by_argument_ = value; }
  void reset() { same_ = false; }

public:
  Gate() {
    if (ros::Time::isSimTime()) by_condition_ = true;
    enable();
    set(true);
    reset();
    pub_ = nh_.advertise<std_msgs::Bool>("out", 1);
    sub_ = nh_.subscribe("in", 1, &Gate::onIn, this);
    set_ = nh_.subscribe("set", 1, &Gate::onSet, this);
  }
  void onIn(const std_msgs::Bool& msg) {
    if (by_condition_ && by_helper_ && by_argument_ && !same_) pub_.publish(msg);
    by_condition_ = msg.data;
    enable();
    set(msg.data);
    reset();
  }
  void onSet(const std_msgs::Bool& msg) { same_ = msg.data; }
};
int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  Gate gate;
  ros::spin();
}
