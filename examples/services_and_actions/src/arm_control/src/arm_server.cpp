#include <cmath>
#include <string>

#include <actionlib/server/simple_action_server.h>
#include <arm_control/ArmControlConfig.h>
#include <arm_msgs/MoveArmAction.h>
#include <arm_msgs/SetGripper.h>
#include <boost/bind.hpp>
#include <dynamic_reconfigure/server.h>
#include <ros/ros.h>
#include <sensor_msgs/JointState.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

namespace arm_control
{
typedef actionlib::SimpleActionServer<arm_msgs::MoveArmAction> MoveArmServer;

class ArmServer
{
public:
  ArmServer()
    : nh_("arm"), pnh_("~"), move_server_(nh_, "move", boost::bind(&ArmServer::onMove, this, _1), false), reconfigure_server_(pnh_)
  {
    gripper_server_ = nh_.advertiseService("set_gripper", &ArmServer::onSetGripper, this);
    home_server_ = nh_.advertiseService("home", &ArmServer::onHome, this);
    torque_server_ = nh_.advertiseService<std_srvs::SetBool::Request, std_srvs::SetBool::Response>(
        "enable_torque", [this](std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response) {
          torque_ = request.data;
          response.success = true;
          return true;
        });
    joint_sub_ = nh_.subscribe("/joint_states", 1, &ArmServer::onJointState, this);
    reconfigure_server_.setCallback(boost::bind(&ArmServer::onReconfigure, this, _1, _2));
    move_server_.start();
  }

private:
  void onMove(const arm_msgs::MoveArmGoalConstPtr& goal)
  {
    arm_msgs::MoveArmResult result;
    if (!torque_)
    {
      move_server_.setAborted(result, "torque is off");
      return;
    }
    ros::Rate rate(20);
    double distance = std::abs(goal->target.position.x - position_);
    while (distance > 0.01)
    {
      if (move_server_.isPreemptRequested() || !ros::ok())
      {
        move_server_.setPreempted();
        return;
      }
      arm_msgs::MoveArmFeedback feedback;
      feedback.distance = distance;
      move_server_.publishFeedback(feedback);
      rate.sleep();
      distance = std::abs(goal->target.position.x - position_);
    }
    result.reached = true;
    move_server_.setSucceeded(result);
  }

  bool onSetGripper(arm_msgs::SetGripper::Request& request, arm_msgs::SetGripper::Response& response)
  {
    response.success = request.opening >= 0.0f && request.opening <= 0.1f;
    if (!response.success)
      response.message = "opening out of range";
    return true;
  }

  bool onHome(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response)
  {
    response.success = !move_server_.isActive();
    response.message = response.success ? "going home" : "a motion is active";
    return true;
  }

  void onJointState(const sensor_msgs::JointStateConstPtr& state)
  {
    if (!state->position.empty())
      position_ = state->position.front();
  }

  void onReconfigure(ArmControlConfig& config, uint32_t)
  {
    max_speed_ = config.max_speed;
  }

  ros::NodeHandle nh_;
  ros::NodeHandle pnh_;
  MoveArmServer move_server_;
  dynamic_reconfigure::Server<ArmControlConfig> reconfigure_server_;
  ros::ServiceServer gripper_server_;
  ros::ServiceServer home_server_;
  ros::ServiceServer torque_server_;
  ros::Subscriber joint_sub_;

  bool torque_ = false;
  double position_ = 0.0;
  double max_speed_ = 0.5;
};
}  // namespace arm_control

int main(int argc, char** argv)
{
  ros::init(argc, argv, "arm_server");
  arm_control::ArmServer server;
  ros::MultiThreadedSpinner(4).spin();
  return 0;
}
