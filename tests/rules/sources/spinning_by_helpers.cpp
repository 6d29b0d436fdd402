// A queue that is served in a function of another class is enough.
//
// expect-not: never_spun(_)
// expect: subscriber level
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <std_msgs/Int32.h>

struct Clock {
  void tick() { ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.1)); }
};

void onLevel(const std_msgs::Int32&) {}

int main(int argc, char** argv) {
  ros::init(argc, argv, "level");
  ros::NodeHandle nh;
  ros::Subscriber sub = nh.subscribe("level", 1, onLevel);
  Clock clock;
  while (ros::ok()) clock.tick();
}
