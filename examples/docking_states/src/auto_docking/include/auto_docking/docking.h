#ifndef AUTO_DOCKING_DOCKING_H
#define AUTO_DOCKING_DOCKING_H

#include <geometry_msgs/PointStamped.h>
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_srvs/Trigger.h>

namespace auto_docking
{

enum class State
{
  IDLE,
  SEARCHING,
  APPROACHING,
  DOCKED,
  FAILED
};

/// Turns until the beacon of the dock is seen, then drives towards it until the charger reports contact.
class Docking
{
public:
  Docking(ros::NodeHandle& nh, ros::NodeHandle& private_nh);

private:
  bool onDock(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool onCancel(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  void onBeacon(const geometry_msgs::PointStamped::ConstPtr& beacon);
  void onBumper(const std_msgs::Bool::ConstPtr& pressed);
  void onCharging(const std_msgs::Bool::ConstPtr& charging);
  void onTimer(const ros::TimerEvent& event);
  void drive(double speed, double turn);
  void publishState();

  ros::Publisher velocity_pub_;
  ros::Publisher state_pub_;
  ros::Subscriber beacon_sub_;
  ros::Subscriber bumper_sub_;
  ros::Subscriber charging_sub_;
  ros::ServiceServer dock_server_;
  ros::ServiceServer cancel_server_;
  ros::Timer timer_;

  State state_ = State::IDLE;
  double bearing_ = 0.0;
  double range_;
};

}  // namespace auto_docking

#endif
