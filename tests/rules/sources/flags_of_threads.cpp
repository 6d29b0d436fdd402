// A spinner of several threads lets the other callback run meanwhile.
//
// expect-not: loops_for_callback(_, _)
// expect: changes(_, _, V), variable_name(V, "ready_")
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_srvs/Trigger.h>

class Cook {
public:
  Cook() {
    sub_ = nh_.subscribe("ready", 1, &Cook::onReady, this);
    service_ = nh_.advertiseService("serve", &Cook::onServe, this);
  }

private:
  void onReady(const std_msgs::Bool& message) { ready_ = message.data; }
  bool onServe(std_srvs::Trigger::Request&, std_srvs::Trigger::Response&) {
    while (!ready_) ros::Duration(0.1).sleep();
    return true;
  }
  ros::NodeHandle nh_;
  ros::Subscriber sub_;
  ros::ServiceServer service_;
  bool ready_ = false;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "cook");
  Cook cook;
  ros::MultiThreadedSpinner spinner(2);
  spinner.spin();
}
