#include "arm_client.h"

#include <std_srvs/Trigger.h>

namespace arm_tasks
{
ArmClient::ArmClient(ros::NodeHandle& nh, const std::string& arm) : move_client_(arm + "/move", true)
{
  gripper_client_ = nh.serviceClient<arm_msgs::SetGripper>(arm + "/set_gripper");
  home_client_ = nh.serviceClient<std_srvs::Trigger>(arm + "/home");
  move_client_.waitForServer(ros::Duration(10.0));
}

bool ArmClient::home()
{
  std_srvs::Trigger trigger;
  return home_client_.call(trigger) && trigger.response.success;
}

bool ArmClient::moveTo(const geometry_msgs::Pose& target)
{
  arm_msgs::MoveArmGoal goal;
  goal.target = target;
  move_client_.sendGoal(goal);
  if (!move_client_.waitForResult(ros::Duration(30.0)))
  {
    move_client_.cancelGoal();
    return false;
  }
  return move_client_.getState() == actionlib::SimpleClientGoalState::SUCCEEDED;
}

bool ArmClient::setGripper(double opening)
{
  arm_msgs::SetGripper service;
  service.request.opening = opening;
  return gripper_client_.call(service) && service.response.success;
}
}  // namespace arm_tasks
