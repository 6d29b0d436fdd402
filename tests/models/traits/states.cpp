// expect: never_is 17 ::state State::DOCKED
// expect: never_is 21 ::mode 3
#include <ros/ros.h>
#include <std_msgs/String.h>

enum class State { IDLE, DRIVING, DOCKED };
State state = State::IDLE;
int mode = 0;
int level = 0;
ros::Publisher pub;

void onGo(const std_msgs::String& message) {
  if (state == State::IDLE) {
    state = State::DRIVING;
    pub.publish(message);
  }
  if (state == State::DOCKED) pub.publish(message);
  if (state == State::DRIVING) state = State::IDLE;
  switch (mode) {
    case 0: mode = 1; pub.publish(message); break;
    case 3: pub.publish(message); break;
    case 1: mode = 0; break;
  }
  level = message.data.size();
  if (level == 7) pub.publish(message);
}

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  pub = nh.advertise<std_msgs::String>("/out", 1);
  ros::Subscriber sub = nh.subscribe("/go", 1, onGo);
  ros::spin();
}
