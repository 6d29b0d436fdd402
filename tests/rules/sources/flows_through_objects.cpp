// The message is kept by an object with setters and getters, and an array is changed through a reference to its element.
//
// expect: port_flow([_, _, "/speed"], [_, _, "/plan"], "data", "deferred")
// expect: port_flow([_, _, "/path"], [_, _, "/plan"], "data", "deferred")
// expect: Count = count : { port_flow(_, _, _, _) }, Count = 2
// expect-not: may_skip(_, _, _)
#include <geometry_msgs/Twist.h>
#include <nav_msgs/Path.h>
#include <ros/ros.h>

class Planner
{
public:
  void setSpeed(double speed) { speed_ = speed; }
  double speed() const { return speed_; }

private:
  double speed_ = 0;
};

class Node
{
public:
  Node()
  {
    speed_sub_ = nh_.subscribe("/speed", 1, &Node::onSpeed, this);
    path_sub_ = nh_.subscribe("/path", 1, &Node::onPath, this);
    pub_ = nh_.advertise<nav_msgs::Path>("/plan", 1);
  }
  void run()
  {
    ros::Rate rate(5);
    while (ros::ok())
    {
      ros::spinOnce();
      nav_msgs::Path plan = path_;
      for (auto& pose : plan.poses)
        pose.pose.position.z = planner_.speed();
      pub_.publish(plan);
      rate.sleep();
    }
  }

private:
  void onSpeed(const geometry_msgs::Twist::ConstPtr& twist) { planner_.setSpeed(twist->linear.x); }
  void onPath(const nav_msgs::Path::ConstPtr& path) { path_ = *path; }

  ros::NodeHandle nh_;
  ros::Subscriber speed_sub_, path_sub_;
  ros::Publisher pub_;
  Planner planner_;
  nav_msgs::Path path_;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "planner");
  Node node;
  node.run();
}
