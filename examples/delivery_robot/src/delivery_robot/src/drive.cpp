#include <geometry_msgs/Twist.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <std_msgs/Float32.h>

// Motors and battery.
class Drive
{
public:
  Drive() : private_nh_("~")
  {
    private_nh_.param("max_speed", max_speed_, 0.8);
    private_nh_.param("publish_battery", publish_battery_, true);
    private_nh_.param<std::string>("odom_topic", odom_topic_, "odom");  // expect: finding name-ignores-parameter
    odometry_pub_ = nh_.advertise<nav_msgs::Odometry>("odom", 10);  // expect: publisher odom nav_msgs/Odometry
    battery_pub_ = nh_.advertise<std_msgs::Float32>("battery", 1, true);
    command_sub_ = nh_.subscribe("cmd_vel", 1, &Drive::onCommand, this);  // expect: subscriber cmd_vel callback=Drive::onCommand
    timer_ = nh_.createTimer(ros::Duration(0.05), &Drive::onTimer, this);  // expect: periodic odom 20 Hz
  }

private:
  void onCommand(const geometry_msgs::Twist::ConstPtr& command)
  {
    speed_ = std::min(command->linear.x, max_speed_);
  }

  void onTimer(const ros::TimerEvent& event)
  {
    nav_msgs::Odometry odometry;
    odometry.header.stamp = event.current_real;
    odometry.twist.twist.linear.x = speed_;
    odometry_pub_.publish(odometry);
    if (publish_battery_)
    {
      std_msgs::Float32 battery;
      battery.data = 1.0f;
      battery_pub_.publish(battery);
    }
  }

  ros::NodeHandle nh_;
  ros::NodeHandle private_nh_;
  ros::Publisher odometry_pub_;
  ros::Publisher battery_pub_;
  ros::Subscriber command_sub_;
  ros::Timer timer_;
  std::string odom_topic_;
  bool publish_battery_;
  double max_speed_;
  double speed_ = 0.0;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "drive");
  Drive drive;
  ros::spin();
  return 0;
}
