// What a constructor sets through a reference, a pointer, or by calculating does not begin with what its declaration says; another value
// is not known either.
// expect: state Gate::by_reference_ = None
// expect: state Gate::by_function_ = None
// expect: state Gate::by_pointer_ = None
// expect: state Gate::counted_ = None
// expect: state Gate::plain_ = true
// expect: reactive in -> out may [by_function_ && by_reference_ && by_pointer_ && plain_ && counted_ > 2]
// expect: transition Gate::by_function_ . None on in [] := msg.data
// expect: transition Gate::by_pointer_ . None on in [] := msg.data
// expect: transition Gate::by_reference_ . None on in [] := msg.data
// expect: transition Gate::counted_ . None on in [] := 0
// expect: transition Gate::plain_ . None on in [] := msg.data
#include <ros/ros.h>
#include <std_msgs/Bool.h>
void configure(bool& value) { value = ros::Time::now().toSec() > 5; }
class Gate {
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  ros::Subscriber sub_;
  bool by_reference_ = true;
  bool by_function_ = true;
  bool by_pointer_ = true;
  bool plain_ = true;
  int counted_ = 1;

public:
  Gate() {
    configure(by_function_);
    bool& other = by_reference_;
    other = false;
    bool* place = &by_pointer_;
    *place = false;
    counted_ += 2;
    pub_ = nh_.advertise<std_msgs::Bool>("out", 1);
    sub_ = nh_.subscribe("in", 1, &Gate::onIn, this);
  }
  void onIn(const std_msgs::Bool& msg) {
    if (by_function_ && by_reference_ && by_pointer_ && plain_ && counted_ > 2) pub_.publish(msg);
    by_reference_ = msg.data;
    by_function_ = msg.data;
    by_pointer_ = msg.data;
    plain_ = msg.data;
    counted_ = 0;
  }
};
int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  Gate gate;
  ros::spin();
}
