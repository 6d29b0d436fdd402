// A constructor lets callbacks run until the first message is there, beside a spinner with a thread of its own; the server is started, and the timer made, after that.
//
// expect: concurrent_callbacks(F, G), function_name(F, "Follower::onState"), function_name(G, "Follower::onEarlyTimer")
// expect-not: concurrent_callbacks(F, G), function_name(F, "Follower::onGoal")
// expect-not: concurrent_callbacks(F, G), function_name(G, "Follower::onGoal")
// expect-not: concurrent_callbacks(F, G), function_name(F, "Follower::onLateTimer")
// expect-not: changed_at_once(V, E, D), variable_name(V, "active_")
#include <actionlib/server/action_server.h>
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <tf2_msgs/LookupTransformAction.h>

class Follower
{
public:
  typedef actionlib::ActionServer<tf2_msgs::LookupTransformAction> Server;

  explicit Follower(ros::NodeHandle& nh)
  {
    server_.reset(new Server(nh, "follow", boost::bind(&Follower::onGoal, this, _1), boost::bind(&Follower::onCancel, this, _1), false));
    pub_ = nh.advertise<std_msgs::Empty>("command", 1);
    sub_ = nh.subscribe("state", 1, &Follower::onState, this);
    early_timer_ = nh.createTimer(ros::Duration(1.0), &Follower::onEarlyTimer, this);
    while (ros::ok() && !heard_)
    {
      ros::spinOnce();
      ros::WallDuration(0.1).sleep();
    }
    late_timer_ = nh.createTimer(ros::Duration(2.0), &Follower::onLateTimer, this);
    server_->start();
  }

private:
  void onGoal(Server::GoalHandle goal)
  {
    active_ = true;
    if (active_) pub_.publish(std_msgs::Empty());
  }
  void onCancel(Server::GoalHandle goal) {}
  void onState(const std_msgs::Empty&)
  {
    heard_ = true;
    active_ = false;
  }
  void onEarlyTimer(const ros::TimerEvent&)
  {
    if (active_) pub_.publish(std_msgs::Empty());
  }
  void onLateTimer(const ros::TimerEvent&) {}

  boost::shared_ptr<Server> server_;
  ros::Publisher pub_;
  ros::Subscriber sub_;
  ros::Timer early_timer_, late_timer_;
  bool heard_ = false;
  bool active_ = false;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "follower");
  ros::NodeHandle nh;
  ros::AsyncSpinner spinner(1);
  spinner.start();
  Follower follower(nh);
  ros::waitForShutdown();
}
