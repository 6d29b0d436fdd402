#ifndef ARM_TASKS_ARM_CLIENT_H
#define ARM_TASKS_ARM_CLIENT_H

#include <string>

#include <actionlib/client/simple_action_client.h>
#include <arm_msgs/MoveArmAction.h>
#include <arm_msgs/SetGripper.h>
#include <geometry_msgs/Pose.h>
#include <ros/ros.h>

namespace arm_tasks
{
/// The arm as its users see it: blocking calls that tell whether they succeeded.
class ArmClient
{
public:
  ArmClient(ros::NodeHandle& nh, const std::string& arm);

  bool home();
  bool moveTo(const geometry_msgs::Pose& target);
  bool setGripper(double opening);

private:
  actionlib::SimpleActionClient<arm_msgs::MoveArmAction> move_client_;
  ros::ServiceClient gripper_client_;
  ros::ServiceClient home_client_;
};
}  // namespace arm_tasks

#endif
