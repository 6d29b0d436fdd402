// Timers that run once: those that a callback makes, or starts, anew send again and again; one that is made at the start sends once.
//
// expect: sent_untimed([_, _, "made"])
// expect: sent_untimed([_, _, "started"])
// expect: 2 = count : { sent_untimed(_) }
#include <ros/ros.h>
#include <std_msgs/Empty.h>

class Delay {
public:
  Delay() {
    made_ = nh_.advertise<std_msgs::Empty>("made", 1);
    started_ = nh_.advertise<std_msgs::Empty>("started", 1);
    first_ = nh_.advertise<std_msgs::Empty>("first", 1);
    in_ = nh_.subscribe("in", 1, &Delay::onIn, this);
    at_first_ = nh_.createTimer(ros::Duration(1.0), &Delay::onFirst, this, true);
    stopped_ = nh_.createTimer(ros::Duration(1.0), &Delay::onStarted, this, true, false);
  }

private:
  void onIn(const std_msgs::Empty&) {
    anew_ = nh_.createTimer(ros::Duration(0.5), &Delay::onMade, this, true);
    stopped_.stop();
    stopped_.start();
  }
  void onMade(const ros::TimerEvent&) { made_.publish(std_msgs::Empty()); }
  void onStarted(const ros::TimerEvent&) { started_.publish(std_msgs::Empty()); }
  void onFirst(const ros::TimerEvent&) { first_.publish(std_msgs::Empty()); }
  ros::NodeHandle nh_;
  ros::Publisher made_, started_, first_;
  ros::Subscriber in_;
  ros::Timer anew_, stopped_, at_first_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "delay");
  Delay delay;
  ros::spin();
}
