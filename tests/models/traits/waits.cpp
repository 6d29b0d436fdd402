// expect: awaits /command /odom Driver::has_odom_
#include <ros/ros.h>
#include <std_msgs/String.h>

class Driver {
 public:
  Driver() {
    pub_ = nh_.advertise<std_msgs::String>("/command", 1);
    log_ = nh_.advertise<std_msgs::String>("/log", 1);
    odom_ = nh_.subscribe("/odom", 1, &Driver::onOdom, this);
    path_ = nh_.subscribe("/path", 1, &Driver::onPath, this);
  }

 private:
  void onOdom(const std_msgs::String&) { has_odom_ = true; }
  void onPath(const std_msgs::String& path) {
    if (!has_odom_) {
      log_.publish(path);
      return;
    }
    drive(path);
  }
  void drive(const std_msgs::String& path) { pub_.publish(path); }

  ros::NodeHandle nh_;
  ros::Publisher pub_, log_;
  ros::Subscriber odom_, path_;
  bool has_odom_ = false;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  Driver driver;
  ros::spin();
}
