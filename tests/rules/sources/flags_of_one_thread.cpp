// ros::spin runs all callbacks in one thread: the loop never ends. A loop that spins itself goes on, one over elements ends with the last of them.
//
// expect: 1 = count : { loops_for_callback(_, _) }, loops_for_callback(_, "ready_")
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_srvs/Trigger.h>
#include <vector>

class Cook {
public:
  Cook() {
    sub_ = nh_.subscribe("ready", 1, &Cook::onReady, this);
    service_ = nh_.advertiseService("serve", &Cook::onServe, this);
  }

private:
  void onReady(const std_msgs::Bool& message) {
    ready_ = seen_ = message.data;
    guests_ = {1, 2};
  }
  bool onServe(std_srvs::Trigger::Request&, std_srvs::Trigger::Response&) {
    while (!ready_) ros::Duration(0.1).sleep();
    while (!seen_) ros::spinOnce();
    for (int guest : guests_) served_ += guest;
    return true;
  }
  ros::NodeHandle nh_;
  ros::Subscriber sub_;
  ros::ServiceServer service_;
  bool ready_ = false, seen_ = false;
  std::vector<int> guests_;
  int served_ = 0;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "cook");
  Cook cook;
  ros::spin();
}
