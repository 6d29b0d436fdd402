#include <auto_docking/docking.h>

#include <geometry_msgs/Twist.h>
#include <std_msgs/UInt8.h>

namespace auto_docking
{

Docking::Docking(ros::NodeHandle& nh, ros::NodeHandle& private_nh)
{
  private_nh.param("range", range_, 2.0);

  velocity_pub_ = nh.advertise<geometry_msgs::Twist>("cmd_vel", 1);
  state_pub_ = private_nh.advertise<std_msgs::UInt8>("state", 1, true);

  beacon_sub_ = nh.subscribe("beacon", 1, &Docking::onBeacon, this);
  bumper_sub_ = nh.subscribe("bumper", 5, &Docking::onBumper, this);
  charging_sub_ = nh.subscribe("charging", 5, &Docking::onCharging, this);
  dock_server_ = private_nh.advertiseService("dock", &Docking::onDock, this);
  cancel_server_ = private_nh.advertiseService("cancel", &Docking::onCancel, this);

  timer_ = nh.createTimer(ros::Duration(0.05), &Docking::onTimer, this);
}

bool Docking::onDock(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response)
{
  if (state_ != State::IDLE && state_ != State::FAILED)
  {
    response.message = "busy";
    return true;
  }
  state_ = State::SEARCHING;
  publishState();
  response.success = true;
  return true;
}

bool Docking::onCancel(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response)
{
  state_ = State::IDLE;
  publishState();
  response.success = true;
  return true;
}

void Docking::onBeacon(const geometry_msgs::PointStamped::ConstPtr& beacon)
{
  bearing_ = beacon->point.y;
  if (state_ == State::SEARCHING && beacon->point.x < range_)
  {
    state_ = State::APPROACHING;
    publishState();
  }
}

void Docking::onBumper(const std_msgs::Bool::ConstPtr& pressed)
{
  if (!pressed->data)
    return;
  if (state_ == State::SEARCHING || state_ == State::APPROACHING)
  {
    state_ = State::FAILED;
    drive(-0.1, 0.0);
  }
}

void Docking::onCharging(const std_msgs::Bool::ConstPtr& charging)
{
  if (charging->data && state_ == State::APPROACHING)
  {
    state_ = State::DOCKED;
    drive(0.0, 0.0);
  }
  else if (!charging->data && state_ == State::DOCKED)
  {
    state_ = State::IDLE;
  }
}

void Docking::onTimer(const ros::TimerEvent&)
{
  switch (state_)
  {
    case State::SEARCHING:
      drive(0.0, 0.4);
      break;
    case State::APPROACHING:
      drive(0.1, bearing_);
      break;
    default:
      break;
  }
}

void Docking::drive(double speed, double turn)
{
  geometry_msgs::Twist twist;
  twist.linear.x = speed;
  twist.angular.z = turn;
  velocity_pub_.publish(twist);
}

void Docking::publishState()
{
  std_msgs::UInt8 msg;
  msg.data = static_cast<uint8_t>(state_);
  state_pub_.publish(msg);
}

}  // namespace auto_docking

int main(int argc, char** argv)
{
  ros::init(argc, argv, "docking");
  ros::NodeHandle nh;
  ros::NodeHandle private_nh("~");
  auto_docking::Docking docking(nh, private_nh);
  ros::spin();
  return 0;
}
