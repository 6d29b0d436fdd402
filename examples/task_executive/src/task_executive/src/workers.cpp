#include <actionlib/server/action_server.h>
#include <actionlib/server/simple_action_server.h>
#include <boost/make_shared.hpp>
#include <move_base_msgs/MoveBaseAction.h>
#include <ros/ros.h>

class Workers
{
public:
  typedef actionlib::SimpleActionServer<move_base_msgs::MoveBaseAction> Server;
  typedef actionlib::ActionServer<move_base_msgs::MoveBaseAction> Queue;

  Workers()
    : nh_("workers")
    , sweep_(nh_, "sweep", boost::bind(&Workers::onSweep, this, _1), false)
    , mop_("mop", false)
    , queue_(nh_, "queue", boost::bind(&Workers::onQueued, this, _1), boost::bind(&Workers::onDropped, this, _1), false)
  {
    mop_.registerGoalCallback(boost::bind(&Workers::onMop, this));
    mop_.registerPreemptCallback(boost::bind(&Workers::onStop, this));
    wax_.reset(new Server("wax", boost::bind(&Workers::onSweep, this, _1)));
    dry_ = boost::make_shared<Server>(nh_, "dry", boost::bind(&Workers::onSweep, this, _1), false);
    inspect_ = new Server(ros::this_node::getName() + "/inspect", [this](const move_base_msgs::MoveBaseGoalConstPtr& goal) { onSweep(goal); inspect_->setSucceeded(); }, false);
    sweep_.start();
    mop_.start();
    queue_.start();
  }

private:
  void onSweep(const move_base_msgs::MoveBaseGoalConstPtr& goal)
  {
    ROS_INFO("to %f", goal->target_pose.pose.position.x);
  }

  void onMop()
  {
    mop_.acceptNewGoal();
  }

  void onStop()
  {
    mop_.setPreempted();
  }

  void onQueued(Queue::GoalHandle goal)
  {
    goal.setAccepted();
  }

  void onDropped(Queue::GoalHandle goal)
  {
    goal.setCanceled();
  }

  ros::NodeHandle nh_;
  Server sweep_, mop_;
  Queue queue_;
  boost::shared_ptr<Server> wax_, dry_;
  Server* inspect_;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "workers");
  Workers workers;
  ros::spin();
  return 0;
}
