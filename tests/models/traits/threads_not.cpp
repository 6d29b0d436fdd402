// one thread
#include <mutex>
#include <ros/ros.h>
#include <std_msgs/String.h>

ros::Publisher pub;
bool busy = false, kept = false, over = false;
std::mutex mutex;

void onGo(const std_msgs::String& m) { if (!busy) pub.publish(m); busy = true; }
void onStop(const std_msgs::String&) { busy = false; }
void onKeep(const std_msgs::String& m) { std::lock_guard<std::mutex> lock(mutex); if (!kept) pub.publish(m); kept = true; }
void onEnd(const std_msgs::String& m) { if (!over) pub.publish(m); over = true; }
void onQuit(const std_msgs::String&) { over = true; }
void onLose(const std_msgs::String&) { std::lock_guard<std::mutex> lock(mutex); kept = false; }

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  pub = nh.advertise<std_msgs::String>("/out", 1);
  ros::Subscriber a = nh.subscribe("/go", 1, onGo);
  ros::Subscriber b = nh.subscribe("/stop", 1, onStop);
  ros::Subscriber c = nh.subscribe("/keep", 1, onKeep);
  ros::Subscriber d = nh.subscribe("/lose", 1, onLose);
  ros::Subscriber e = nh.subscribe("/end", 1, onEnd);
  ros::Subscriber f = nh.subscribe("/quit", 1, onQuit);
  ros::MultiThreadedSpinner spinner(1);
  spinner.spin();
}
