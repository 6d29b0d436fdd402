// A variable that decides whether a timer is made, or begins its period anew, is state; one that only decides whether a timer ends is not.
//
// expect: state ticks_ = 0
// expect: state made_ = false
// expect-only: state
// expect-not: _not_with(_, _, _, _)
// expect: 1 = count : { stops_timer(_, _) }
#include <ros/ros.h>

class Lamp {
 public:
  Lamp() {
    dim_ = nh_.createTimer(ros::Duration(1.0), &Lamp::dim, this, true, false);
    tick_ = nh_.createTimer(ros::Duration(2.0), &Lamp::tick, this);
  }

 private:
  void tick(const ros::TimerEvent&) {
    if (ticks_++ % 3 == 0) dim_.start();
    if (!made_) {
      made_ = true;
      blink_ = nh_.createTimer(ros::Duration(0.1), &Lamp::blink, this);
    }
    if (ended_++ > 10) blink_.stop();
  }
  void dim(const ros::TimerEvent&) { ROS_INFO("dim"); }
  void blink(const ros::TimerEvent&) { ROS_INFO("blink"); }

  ros::NodeHandle nh_;
  ros::Timer tick_, dim_, blink_;
  int ticks_ = 0;
  int ended_ = 0;
  bool made_ = false;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "lamp");
  Lamp lamp;
  ros::spin();
}
