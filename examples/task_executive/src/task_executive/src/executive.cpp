#include <memory>

#include <actionlib/client/action_client.h>
#include <actionlib/client/simple_action_client.h>
#include <move_base_msgs/MoveBaseAction.h>
#include <ros/ros.h>

class Executive
{
public:
  Executive() : nh_("fleet"), base_("move_base", true), arm_(nh_, "arm"), fleet_(nh_, "tasks")
  {
    lift_ = std::make_unique<Client>("lift", true);
    base_.sendGoal(move_base_msgs::MoveBaseGoal(), boost::bind(&Executive::onDone, this, _1, _2), boost::bind(&Executive::onActive, this),
                   boost::bind(&Executive::onFeedback, this, _1));
    arm_.sendGoal(move_base_msgs::MoveBaseGoal(), &Executive::onArmDone);
    task_ = fleet_.sendGoal(move_base_msgs::MoveBaseGoal(), boost::bind(&Executive::onTransition, this, _1));
    lift_->sendGoalAndWait(move_base_msgs::MoveBaseGoal(), ros::Duration(5));
  }

private:
  typedef actionlib::SimpleActionClient<move_base_msgs::MoveBaseAction> Client;
  typedef actionlib::ActionClient<move_base_msgs::MoveBaseAction> Tasks;

  void onDone(const actionlib::SimpleClientGoalState& state, const move_base_msgs::MoveBaseResultConstPtr&)
  {
    ROS_INFO("%s", state.toString().c_str());
  }

  static void onArmDone(const actionlib::SimpleClientGoalState& state, const move_base_msgs::MoveBaseResultConstPtr&)
  {
    ROS_INFO("arm: %s", state.toString().c_str());
  }

  void onActive()
  {
    ROS_INFO("started");
  }

  void onFeedback(const move_base_msgs::MoveBaseFeedbackConstPtr& feedback)
  {
    ROS_INFO("at %f", feedback->base_position.pose.position.x);
  }

  void onTransition(Tasks::GoalHandle goal)
  {
    ROS_INFO("%s", goal.getCommState().toString().c_str());
  }

  ros::NodeHandle nh_;
  Client base_, arm_;
  std::unique_ptr<Client> lift_;
  Tasks fleet_;
  Tasks::GoalHandle task_;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "executive");
  Executive executive;
  ros::spin();
  return 0;
}
