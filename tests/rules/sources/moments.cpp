// Moments that members keep; not one that is set back, one from which another time is taken, or one that comes with messages.
//
// expect: keeps_moment(V), variable_name(V, "last_")
// expect: keeps_moment(V), variable_name(V, "heard_")
// expect: 2 = count : { keeps_moment(_) }
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <std_msgs/Header.h>

class Node {
public:
  Node() {
    pub_ = nh_.advertise<std_msgs::Empty>("out", 1);
    in_ = nh_.subscribe("in", 1, &Node::onIn, this);
    reset_ = nh_.subscribe("reset", 1, &Node::onReset, this);
  }

private:
  void onIn(const std_msgs::Header& msg) {
    const ros::Time now = ros::Time::now();
    if ((now - last_).toSec() > 0.5 && now - back_ > ros::Duration(1) && msg.stamp - stamp_ > ros::Duration(1) && msg.stamp - other_ > ros::Duration(1)) {
      pub_.publish(std_msgs::Empty());
      last_ = now;
      back_ = now;
    }
    if ((ros::Time::now() - heard_).toSec() < 2.0) pub_.publish(std_msgs::Empty());
    heard_ = ros::Time::now();
    stamp_ = msg.stamp;
    other_ = ros::Time::now();
  }
  void onReset(const std_msgs::Empty&) { back_ = ros::Time(0); }

  ros::NodeHandle nh_;
  ros::Publisher pub_;
  ros::Subscriber in_, reset_;
  ros::Time last_, back_, heard_, stamp_, other_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  Node node;
  ros::spin();
}
