// A callback that sets a state variable, and sets it otherwise before it ends; on another branch that is no way on.
//
// expect: moves_on([_, _, "/go"], "g_busy", "false", "true")
// expect: moves_on([_, _, "/go"], "g_busy", "true", "false")
// expect: moves_on([_, _, "/turn"], "g_left", "false", "true")
// expect: moves_on([_, _, "/turn"], "g_left", "true", "false")
// expect: moves_on([_, _, "/stop"], "g_stopped", "false", "true")
// expect: Count = count : { moves_on(_, _, _, _) }, Count = 5
#include <ros/ros.h>
#include <std_msgs/Bool.h>

bool g_busy = false;
bool g_left = false;
bool g_stopped = false;
ros::Publisher g_pub;

void onGo(const std_msgs::Bool& message) {
  if (g_busy) return;
  g_busy = true;
  ros::Duration(2.0).sleep();
  if (message.data) g_pub.publish(message);
  g_busy = false;
}

void onTurn(const std_msgs::Bool& message) {
  if (message.data) g_left = true;
  else g_left = false;
  if (g_left) g_pub.publish(message);
}

void onStop(const std_msgs::Bool& message) {
  if (g_stopped) return;
  if (message.data) g_stopped = true;
  else g_pub.publish(message);
}

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  g_pub = nh.advertise<std_msgs::Bool>("/out", 1);
  ros::Subscriber go = nh.subscribe("/go", 1, onGo);
  ros::Subscriber turn = nh.subscribe("/turn", 1, onTurn);
  ros::Subscriber stop = nh.subscribe("/stop", 1, onStop);
  ros::spin();
}
