// Goals and wishes to end them are handled by a function each.
#include <actionlib/server/simple_action_server.h>
#include <actionlib/TestAction.h>
#include <ros/ros.h>
#include <std_msgs/Float32.h>

enum State { IDLE, SCAN };

class Docking {
public:
  Docking() : state_(IDLE), server_(nh_, "dock", false) {
    server_.registerGoalCallback(boost::bind(&Docking::onGoal, this));
    server_.registerPreemptCallback(boost::bind(&Docking::onPreempt, this));
    velocity_ = nh_.advertise<std_msgs::Float32>("velocity", 1);
    ir_ = nh_.subscribe("ir", 1, &Docking::onIr, this);
    server_.start();
  }
  void onGoal() {
    server_.acceptNewGoal();
    state_ = SCAN;
  }
  void onPreempt() {
    state_ = IDLE;
    server_.setPreempted();
  }
  void onIr(const std_msgs::Float32& ir) {
    if (state_ == SCAN) velocity_.publish(ir);
  }

private:
  ros::NodeHandle nh_;
  ros::Publisher velocity_;
  ros::Subscriber ir_;
  State state_;
  actionlib::SimpleActionServer<actionlib::TestAction> server_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "docking");
  Docking docking;
  ros::spin();
}
