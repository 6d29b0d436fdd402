#include <geometry_msgs/TransformStamped.h>
#include <geometry_msgs/Twist.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <sensor_msgs/JointState.h>
#include <tf2_ros/transform_broadcaster.h>

#include <cmath>

// The motor board of the real robot: drives as it is told and reports how far it came.
class BaseDriver
{
public:
  BaseDriver() : private_nh_("~")
  {
    private_nh_.param("rate", rate_, 20.0);
    private_nh_.param<std::string>("odom_frame", odom_frame_, "odom");
    odometry_pub_ = nh_.advertise<nav_msgs::Odometry>("odom", 10);
    wheels_pub_ = nh_.advertise<sensor_msgs::JointState>("joint_states", 10);
    command_sub_ = nh_.subscribe("cmd_vel", 1, &BaseDriver::onCommand, this);
  }

  void run()
  {
    ros::Rate rate(rate_);
    while (ros::ok())
    {
      ros::spinOnce();
      x_ += command_.linear.x * std::cos(heading_) / rate_;
      y_ += command_.linear.x * std::sin(heading_) / rate_;
      heading_ += command_.angular.z / rate_;
      publish(ros::Time::now());
      rate.sleep();
    }
  }

private:
  void onCommand(const geometry_msgs::Twist::ConstPtr& command) { command_ = *command; }

  void publish(const ros::Time& now)
  {
    nav_msgs::Odometry odometry;
    odometry.header.stamp = now;
    odometry.header.frame_id = odom_frame_;
    odometry.pose.pose.position.x = x_;
    odometry.pose.pose.position.y = y_;
    odometry_pub_.publish(odometry);

    geometry_msgs::TransformStamped transform;
    transform.header = odometry.header;
    transform.child_frame_id = "base_link";
    transform.transform.translation.x = x_;
    transform.transform.translation.y = y_;
    transform.transform.rotation.z = std::sin(heading_ / 2);
    transform.transform.rotation.w = std::cos(heading_ / 2);
    transforms_.sendTransform(transform);

    sensor_msgs::JointState wheels;
    wheels.header.stamp = now;
    wheels.name = {"left_wheel_joint", "right_wheel_joint"};
    wheels.position = {x_ / 0.1, x_ / 0.1};
    wheels_pub_.publish(wheels);
  }

  ros::NodeHandle nh_;
  ros::NodeHandle private_nh_;
  ros::Publisher odometry_pub_;
  ros::Publisher wheels_pub_;
  ros::Subscriber command_sub_;
  tf2_ros::TransformBroadcaster transforms_;
  geometry_msgs::Twist command_;
  std::string odom_frame_;
  double rate_;
  double x_ = 0.0;
  double y_ = 0.0;
  double heading_ = 0.0;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "base_driver");
  BaseDriver driver;
  driver.run();
  return 0;
}
