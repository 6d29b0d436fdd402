// A callback keeps the message, a timer makes the output from its field. Whatever arrives is sent on, by the next run.
//
// expect: port_flow([_, _, "/pose"], [_, _, "/goal"], "data", "deferred")
// expect: flow_variable([_, _, "/pose"], [_, _, "/goal"], "Follower::pose_")
// expect: flow_always([_, _, "/pose"], [_, _, "/goal"], "deferred")
// expect: round_always(_, [_, _, "/goal"])
// expect: field_flow([_, _, "/pose"], "position.x", [_, _, "/goal"], "x")
// expect: Fields = count : { field_flow(_, _, _, _) }, Fields = 1
// expect: Count = count : { port_flow(_, _, _, _) }, Count = 1
// expect-not: assigned_object(_, _); _entry_call(_, _, _); _frame_of(_, _, _); _answered_to(_, _)
#include <geometry_msgs/Point.h>
#include <geometry_msgs/Pose.h>
#include <ros/ros.h>

class Follower
{
public:
  Follower()
  {
    sub_ = nh_.subscribe("/pose", 1, &Follower::onPose, this);
    pub_ = nh_.advertise<geometry_msgs::Point>("/goal", 1);
    timer_ = nh_.createTimer(ros::Duration(0.1), &Follower::onTimer, this);
  }

private:
  void onPose(const geometry_msgs::Pose::ConstPtr& msg) { pose_ = *msg; }
  void onTimer(const ros::TimerEvent&)
  {
    geometry_msgs::Point goal;
    goal.x = pose_.position.x + 1;
    pub_.publish(goal);
  }

  ros::NodeHandle nh_;
  ros::Subscriber sub_;
  ros::Publisher pub_;
  ros::Timer timer_;
  geometry_msgs::Pose pose_;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "follower");
  Follower follower;
  ros::spin();
}
