// A period that begins with a number and is what a parameter says when the timer is made: the rate is that of the parameter.
//
// expect: periodic timer 4.0 period /out []
#include <ros/ros.h>
#include <std_msgs/Empty.h>

class Node
{
public:
  Node()
  {
    pub_ = nh_.advertise<std_msgs::Empty>("/out", 1);
    read();
    start();
  }

private:
  void read() { nh_.param("period", period_, 0.25); }
  void start() { timer_ = nh_.createTimer(ros::Duration(period_), &Node::tick, this); }
  void tick(const ros::TimerEvent&) { pub_.publish(std_msgs::Empty()); }

  ros::NodeHandle nh_;
  ros::Publisher pub_;
  ros::Timer timer_;
  double period_ = 0.1;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  Node node;
  ros::spin();
}
