#include <string>

#include <base_common/status_reporter.h>
#include <base_msgs/WheelTicks.h>
#include <geometry_msgs/Twist.h>
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_msgs/Float64.h>

#include "motor_board.h"

namespace base_driver
{
class BaseDriver
{
public:
  BaseDriver()
    : private_nh_("~"), left_nh_("left_wheel"), right_nh_(nh_, "right_wheel"), status_(private_nh_), ticks_topic_("wheel_ticks")
  {
    private_nh_.param<std::string>("port", device_, "/dev/ttyUSB0");
    private_nh_.param("baud", baud_, 115200);
    wheel_separation_ = private_nh_.param("wheel_separation", 0.38);
    if (!private_nh_.getParam("command_timeout", command_timeout_))
      command_timeout_ = 0.5;

    ticks_pub_ = nh_.advertise<base_msgs::WheelTicks>(ticks_topic_, 10);
    left_speed_pub_ = left_nh_.advertise<std_msgs::Float64>("speed", 1);
    right_speed_pub_ = right_nh_.advertise<std_msgs::Float64>("speed", 1);
    cmd_vel_sub_ = nh_.subscribe("cmd_vel", 1, &BaseDriver::onCommand, this);
    stop_sub_ = nh_.subscribe("/emergency_stop", 1, &BaseDriver::onEmergencyStop, this, ros::TransportHints().tcpNoDelay());
  }

  bool connect()
  {
    if (board_.open(device_, baud_))
      return true;
    status_.report(base_msgs::BaseStatus::ERROR, "cannot open " + device_);
    return false;
  }

  void spin()
  {
    ros::Rate rate(private_nh_.param("rate", 50.0));
    while (ros::ok())
    {
      ros::spinOnce();
      update();
      rate.sleep();
    }
  }

private:
  void onCommand(const geometry_msgs::Twist::ConstPtr& command)
  {
    if (stopped_)
    {
      ROS_WARN_THROTTLE(1.0, "command ignored, emergency stop is active");
      return;
    }
    const double turn = command->angular.z * wheel_separation_ / 2.0;
    setSpeeds(command->linear.x - turn, command->linear.x + turn);
    last_command_ = ros::Time::now();
  }

  void onEmergencyStop(const std_msgs::Bool& stop)
  {
    stopped_ = stop.data;
    if (stopped_)
      setSpeeds(0.0, 0.0);
    status_.report(stopped_ ? base_msgs::BaseStatus::WARN : base_msgs::BaseStatus::OK, stopped_ ? "emergency stop" : "running");
  }

  void update()
  {
    if ((ros::Time::now() - last_command_).toSec() > command_timeout_)
      setSpeeds(0.0, 0.0);

    base_msgs::WheelTicks ticks;
    if (!board_.readTicks(ticks.left, ticks.right))
    {
      status_.report(base_msgs::BaseStatus::ERROR, "no answer from the motor board");
      return;
    }
    ticks.header.stamp = ros::Time::now();
    ticks_pub_.publish(ticks);
  }

  void setSpeeds(double left, double right)
  {
    board_.setSpeeds(left, right);
    publishSpeed(left_speed_pub_, left);
    publishSpeed(right_speed_pub_, right);
  }

  void publishSpeed(ros::Publisher& publisher, double speed)
  {
    std_msgs::Float64 message;
    message.data = speed;
    publisher.publish(message);
  }

  ros::NodeHandle nh_;
  ros::NodeHandle private_nh_;
  ros::NodeHandle left_nh_;
  ros::NodeHandle right_nh_;
  base_common::StatusReporter status_;
  MotorBoard board_;

  std::string ticks_topic_;
  std::string device_;
  int baud_;
  double wheel_separation_;
  double command_timeout_;

  ros::Publisher ticks_pub_;
  ros::Publisher left_speed_pub_;
  ros::Publisher right_speed_pub_;
  ros::Subscriber cmd_vel_sub_;
  ros::Subscriber stop_sub_;

  bool stopped_ = false;
  ros::Time last_command_;
};
}  // namespace base_driver

int main(int argc, char** argv)
{
  ros::init(argc, argv, "base_driver");
  base_driver::BaseDriver driver;
  if (!driver.connect())
    return 1;
  driver.spin();
  return 0;
}
