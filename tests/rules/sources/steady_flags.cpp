// Loops in threads that end by a flag: one that only the destructor clears lasts as long as the node, one that a service clears does not.
//
// expect: 3 = count : { periodic(_, _, _) }
// expect: 1 = count : { unsteady(_, _) }
// expect: unsteady(C, "its loop may end"), location(C, _, 34, _)
#include <atomic>
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <thread>

class Camera {
 public:
  explicit Camera(ros::NodeHandle& n) {
    a_ = n.advertise<std_msgs::Empty>("/a", 1);
    b_ = n.advertise<std_msgs::Empty>("/b", 1);
    c_ = n.advertise<std_msgs::Empty>("/c", 1);
    stop_ = n.subscribe("/stop", 1, &Camera::stop, this);
    first_ = std::thread(&Camera::loopA, this);
    second_ = std::thread(&Camera::loopB, this);
    third_ = std::thread(&Camera::loopC, this);
  }
  ~Camera() { running_ = false; closing_ = true; going_ = false; }
  void stop(const std_msgs::Empty&) { going_ = false; }
  void loopA() {
    ros::Rate rate(10);
    while (ros::ok() && running_) { a_.publish(std_msgs::Empty()); rate.sleep(); }
  }
  void loopB() {
    ros::Rate rate(10);
    while (!closing_.load()) { b_.publish(std_msgs::Empty()); rate.sleep(); }
  }
  void loopC() {
    ros::Rate rate(10);
    while (going_) { c_.publish(std_msgs::Empty()); rate.sleep(); }
  }

 private:
  std::atomic<bool> running_{true}, closing_{false};
  bool going_ = true;
  ros::Publisher a_, b_, c_;
  ros::Subscriber stop_;
  std::thread first_, second_, third_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "camera");
  ros::NodeHandle n;
  Camera camera(n);
  ros::spin();
}
