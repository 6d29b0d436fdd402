// What is sent beside reactions and rounds: by a thread that waits for input, and where nothing is known to call the function.
//
// expect: sent_by_itself([_, "publisher", "out"])
// expect: sent_by_itself([_, "publisher", "told"])
// expect: 2 = count : { sent_by_itself(_) }
#include <iostream>
#include <thread>
#include <ros/ros.h>
#include <std_msgs/Empty.h>

void keep(void (*function)());
ros::Publisher g_told;
void tell() { g_told.publish(std_msgs::Empty()); }

class Panel {
 public:
  Panel() {
    out_ = nh_.advertise<std_msgs::Empty>("out", 1);
    round_ = nh_.advertise<std_msgs::Empty>("round", 1);
    g_told = nh_.advertise<std_msgs::Empty>("told", 1);
    in_ = nh_.subscribe("in", 1, &Panel::onIn, this);
    timer_ = nh_.createTimer(ros::Duration(1.0), &Panel::onTimer, this);
    worker_ = std::thread([this]() { work(); });
    keep(&tell);
  }

 private:
  void onIn(const std_msgs::Empty&) { out_.publish(std_msgs::Empty()); }
  void onTimer(const ros::TimerEvent&) { round_.publish(std_msgs::Empty()); }
  void work() {
    std::string line;
    while (std::getline(std::cin, line)) out_.publish(std_msgs::Empty());
  }

  ros::NodeHandle nh_;
  ros::Publisher out_, round_;
  ros::Subscriber in_;
  ros::Timer timer_;
  std::thread worker_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "panel");
  Panel panel;
  ros::spin();
  return 0;
}
