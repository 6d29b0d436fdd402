// Answers every question, sends what is to be stopped and the map now and then.
// expect: publisher answer
#include <ros/ros.h>
#include <std_msgs/String.h>

ros::Publisher answer_pub, stop_pub, map_pub;

void onQuestion(const std_msgs::String& question) { answer_pub.publish(question); }
void onTimer(const ros::TimerEvent&) {
  std_msgs::String text;
  stop_pub.publish(text);
  map_pub.publish(text);
}

int main(int argc, char** argv) {
  ros::init(argc, argv, "answerer");
  ros::NodeHandle nh;
  answer_pub = nh.advertise<std_msgs::String>("answer", 1);
  stop_pub = nh.advertise<std_msgs::String>("stop", 1);
  map_pub = nh.advertise<std_msgs::String>("map", 1);
  ros::Subscriber sub = nh.subscribe("question", 1, onQuestion);
  ros::Timer timer = nh.createTimer(ros::Duration(1.0), onTimer);
  ros::spin();
}
