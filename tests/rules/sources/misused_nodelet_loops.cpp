// A nodelet whose onInit does not return.
//
// expect: 2 = count : { misused(_, "blocks its host", "onInit") }
#include <nodelet/nodelet.h>
#include <pluginlib/class_list_macros.h>
#include <ros/ros.h>

class Hello : public nodelet::Nodelet {
  void onInit() override {
    ros::Rate rate(2);
    while (ros::ok() && count_ < 3) {
      if (++count_ > 1) break;
    }
    while (ros::ok()) {
      rate.sleep();
    }
    ros::spin();
  }
  void other() {
    while (ros::ok()) {
    }
  }
  int count_ = 0;
};

PLUGINLIB_EXPORT_CLASS(Hello, nodelet::Nodelet)
