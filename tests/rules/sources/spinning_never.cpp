// A program of roscpp whose loop only sleeps: neither its subscription nor its timer ever calls.
//
// expect: never_spun(S), port([S, _, "level"])
// expect: 2 = count : { never_spun(_) }
#include <ros/ros.h>
#include <std_msgs/Int32.h>

struct Level {
  void onLevel(const std_msgs::Int32& message) { level = message.data; }
  void onTimer(const ros::TimerEvent&) { level = 0; }
  int level = 0;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "level");
  ros::NodeHandle nh;
  Level level;
  ros::Subscriber sub = nh.subscribe("level", 1, &Level::onLevel, &level);
  ros::Timer timer = nh.createTimer(ros::Duration(1), &Level::onTimer, &level);
  ros::Rate rate(10);
  while (ros::ok()) rate.sleep();
}
