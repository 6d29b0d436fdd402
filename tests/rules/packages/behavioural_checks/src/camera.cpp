// Several messages at once, and several messages one after the other.
// expect-not: finding burst-overflows "*long*"
// expect-not: finding burst-overflows "*paced*"
// expect-not: finding burst-overflows "*either*"
// expect-not: finding burst-overflows "*many*"
#include <ros/ros.h>
#include <std_msgs/String.h>

ros::Publisher parts_pub, objects_pub, many_pub, paced_pub, either_pub;

void onTrigger(const std_msgs::String& trigger) {
  parts_pub.publish(trigger);
  parts_pub.publish(trigger);
  if (!trigger.data.empty()) parts_pub.publish(trigger);  // expect: finding burst-overflows "/camera sends 3 messages at once on /parts, but /viewer has a queue of 2"
  for (char letter : trigger.data) {
    std_msgs::String object;
    object.data = letter;
    objects_pub.publish(object);  // expect: finding burst-overflows "/camera sends many messages at once on /objects, but /viewer has a queue of 1"
    many_pub.publish(object);
  }
  if (trigger.data.empty()) {
    either_pub.publish(trigger);
  } else {
    either_pub.publish(trigger);
  }
}
void onPaced(const std_msgs::String& trigger) {
  for (int i = 0; i < 3; ++i) {
    paced_pub.publish(trigger);
    ros::Duration(1.0).sleep();
  }
}

int main(int argc, char** argv) {
  ros::init(argc, argv, "camera");
  ros::NodeHandle nh;
  parts_pub = nh.advertise<std_msgs::String>("parts", 10);
  objects_pub = nh.advertise<std_msgs::String>("objects", 10);
  many_pub = nh.advertise<std_msgs::String>("many", 10);
  paced_pub = nh.advertise<std_msgs::String>("paced", 10);
  either_pub = nh.advertise<std_msgs::String>("either", 10);
  ros::Subscriber sub = nh.subscribe("trigger", 1, onTrigger);
  ros::Subscriber paced_sub = nh.subscribe("paced_trigger", 1, onPaced);
  ros::spin();
}
