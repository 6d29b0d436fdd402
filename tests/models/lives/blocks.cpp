// Callbacks that wait for a thread, or may not end; timers out of a container.
// expect: held_up a callback may wait for something
// expect: held_up a callback may run a loop that does not end
// expect: unsteady 20 a callback may wait for something
// expect: unsteady 20 a callback may run a loop that does not end
// expect: unsteady 20 something may be done with it later
// expect: unheard in a callback may wait for something
// expect: unheard in a callback may run a loop that does not end
#include <condition_variable>
#include <mutex>
#include <ros/ros.h>
#include <std_msgs/Int32.h>
#include <vector>

class Node {
public:
  Node() {
    pub_ = nh_.advertise<std_msgs::Int32>("out", 1);
    in_ = nh_.subscribe("in", 1, &Node::onIn, this);
    timer_ = nh_.createTimer(ros::Duration(0.1), &Node::tick, this);
  }

private:
  void onIn(const std_msgs::Int32& msg) {
    std::unique_lock<std::mutex> lock(mutex_);
    if (msg.data > 0) there_.wait(lock);
    if (msg.data > 1)
      while (true) ++count_;
    for (auto& timer : timers_) timer.stop();
  }
  void tick(const ros::TimerEvent&) { pub_.publish(std_msgs::Int32()); }

  ros::NodeHandle nh_;
  ros::Publisher pub_;
  ros::Subscriber in_;
  ros::Timer timer_;
  std::vector<ros::Timer> timers_;
  std::mutex mutex_;
  std::condition_variable there_;
  int count_ = 0;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  Node node;
  ros::spin();
}
