// Threads that nodelets join in their destructor: those that end only with ROS, and those that are told to end, or end by themselves.
//
// expect: 3 = count : { joins_endless(_, _, _) }
// expect: joins_endless(_, _, "assigned_")
// expect: joins_endless(_, _, "reset_")
// expect: joins_endless(_, _, "started_")
#include <atomic>
#include <boost/thread.hpp>
#include <ecl/threads/thread.hpp>
#include <memory>
#include <nodelet/nodelet.h>
#include <pluginlib/class_list_macros.h>
#include <ros/ros.h>
#include <thread>

namespace kitchen {
class Oven : public nodelet::Nodelet {
public:
  ~Oven() override {
    stop_ = true;
    assigned_.join();
    reset_->join();
    started_.join();
    flagged_.join();
    once_.join();
    left_.join();
    interrupted_.interrupt();
    interrupted_.join();
  }
  void onInit() override {
    assigned_ = std::thread(&Oven::bake, this);
    reset_.reset(new std::thread(&Oven::bake, this));
    started_.start(&Oven::bake, *this);
    flagged_ = std::thread(&Oven::watch, this);
    once_ = std::thread(&Oven::heat, this);
    left_ = std::thread(&Oven::wait, this);
    interrupted_ = boost::thread(&Oven::bake, this);
  }

private:
  void bake() {
    ros::Rate rate(10);
    while (ros::ok()) rate.sleep();
  }
  void watch() {
    ros::Rate rate(10);
    while (!stop_ && ros::ok()) rate.sleep();
  }
  void heat() { ros::Duration(1).sleep(); }
  void wait() {
    ros::Rate rate(10);
    while (ros::ok()) {
      if (stop_) break;
      rate.sleep();
    }
  }
  std::thread assigned_, flagged_, once_, left_;
  std::unique_ptr<std::thread> reset_;
  ecl::Thread started_;
  boost::thread interrupted_;
  std::atomic<bool> stop_{false};
};
}  // namespace kitchen
PLUGINLIB_EXPORT_CLASS(kitchen::Oven, nodelet::Nodelet)
