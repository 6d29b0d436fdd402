// Asks again whenever an answer comes, as long as it is on; what it says of `report` ends by itself.
// expect-not: finding livelock "*/report*"
#include <ros/ros.h>
#include <std_msgs/String.h>

bool on = false;
bool counted = false;
ros::Publisher question_pub, count_pub;

void onAnswer(const std_msgs::String& answer) {
  if (!on) return;
  question_pub.publish(answer);
}
void onStop(const std_msgs::String&) {
  if (on) {
    on = false;
  } else {
    on = true;
  }
}
void onReport(const std_msgs::String& report) {
  if (counted) return;
  counted = true;
  count_pub.publish(report);
}

int main(int argc, char** argv) {
  ros::init(argc, argv, "asker");
  ros::NodeHandle nh;
  question_pub = nh.advertise<std_msgs::String>("question", 1);
  count_pub = nh.advertise<std_msgs::String>("log", 1);
  ros::Publisher settings_pub = nh.advertise<std_msgs::String>("settings", 1, true);
  ros::Subscriber answer_sub = nh.subscribe("answer", 1, onAnswer);  // expect: finding livelock "as long as ::on is true, what /asker receives on /answer makes it send on /question, which always comes back to /answer"
  ros::Subscriber stop_sub = nh.subscribe("stop", 1, onStop);
  ros::Subscriber report_sub = nh.subscribe("report", 1, onReport);
  settings_pub.publish(std_msgs::String());
  ros::spin();
}
