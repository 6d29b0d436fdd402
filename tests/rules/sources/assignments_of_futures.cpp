// A member that holds what another thread will give is state; one that holds the thread is not.
//
// expect: 1 = count : { component_variable(V), variable(V, "field") }
// expect: state result_
// expect-only: state
#include <future>
#include <thread>
#include <ros/ros.h>
#include <std_msgs/Float64.h>

class Promised {
 public:
  Promised() {
    pub_ = nh_.advertise<std_msgs::Float64>("out", 1);
    in_ = nh_.subscribe("in", 1, &Promised::onIn, this);
    trigger_ = nh_.subscribe("trigger", 1, &Promised::onTrigger, this);
    worker_ = std::thread(&Promised::work, this);
  }

 private:
  void work() {}
  void onIn(const std_msgs::Float64::ConstPtr& msg) {
    result_ = std::async(std::launch::async, [msg] { return msg->data * 2; });
  }
  void onTrigger(const std_msgs::Float64::ConstPtr& msg) {
    if (!result_.valid()) return;
    pub_.publish(*msg);
  }

  ros::NodeHandle nh_;
  ros::Publisher pub_;
  ros::Subscriber in_, trigger_;
  std::thread worker_;
  std::future<double> result_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "promised");
  Promised node;
  ros::spin();
}
