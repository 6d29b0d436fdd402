// Timers that are to be started and are not.
//
// expect: 2 = count : { misused(_, "timer not started", _) }
#include <ros/ros.h>

class Pump {
public:
  Pump() {
    unstarted_ = nh_.createTimer(ros::Duration(0.1), &Pump::tick, this, false, false);
    once_ = nh_.createTimer(ros::Duration(0.1), &Pump::tick, this, true);
    lambda_ = nh_.createTimer(ros::Duration(0.1), [](const ros::TimerEvent&) {}, false, false);
    running_ = nh_.createTimer(ros::Duration(0.1), &Pump::tick, this, false, true);
    plain_ = nh_.createTimer(ros::Duration(0.1), &Pump::tick, this);
  }

private:
  void tick(const ros::TimerEvent&) {}
  ros::NodeHandle nh_;
  ros::Timer unstarted_, once_, lambda_, running_, plain_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "pump");
  Pump pump;
  ros::spin();
}
