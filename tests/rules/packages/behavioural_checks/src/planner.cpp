// Waits that nothing ends, and waits that somebody, or a limit, ends.
// expect-not: finding waits-for-ever "*/left*"
// expect-not: finding waits-for-ever "*/maybe*"
// expect-not: finding waits-for-ever "*/soon*"
// expect: 1 = count : { flag_setting(_, _, _) }
#include <actionlib/client/simple_action_client.h>
#include <actionlib_tutorials/FibonacciAction.h>
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <std_srvs/Empty.h>

typedef actionlib::SimpleActionClient<actionlib_tutorials::FibonacciAction> Client;

bool has_map = false;
bool has_pose = false;
ros::Publisher plan_pub;

void onMap(const std_msgs::Empty&) { has_map = true; }
void onPose(const std_msgs::Empty& pose) {
  has_pose = true;
  plan_pub.publish(pose);
}

void waitForAction() {
  Client driver("drive", true), other("soon", true);
  while (!driver.waitForServer(ros::Duration(5.0))) ROS_INFO("waiting");  // expect: finding waits-for-ever "/planner waits without a time limit for the action /drive, which no node provides"
  other.waitForServer(ros::Duration(5.0));
}

int main(int argc, char** argv) {
  ros::init(argc, argv, "planner");
  ros::NodeHandle nh;
  plan_pub = nh.advertise<std_msgs::Empty>("plan", 1);
  ros::Subscriber map_sub = nh.subscribe("map", 1, onMap);
  ros::Subscriber pose_sub = nh.subscribe("maybe_pose", 1, onPose);
  ros::ServiceClient clear = nh.serviceClient<std_srvs::Empty>("clear_map");
  ros::ServiceClient reset = nh.serviceClient<std_srvs::Empty>("reset_map");
  ros::ServiceClient served = nh.serviceClient<std_srvs::Empty>("left");
  ros::ServiceClient maybe = nh.serviceClient<std_srvs::Empty>("maybe");
  clear.waitForExistence();                         // expect: finding waits-for-ever "/planner waits without a time limit for the service /clear_map, which no node provides"
  ros::service::waitForService("reset_map", -1);    // expect: finding waits-for-ever "*the service /reset_map,*"
  ros::service::waitForService("left");             // somebody serves it
  maybe.waitForExistence(ros::Duration(2.0));       // with a limit
  ros::service::waitForService("maybe", 2000);
  ros::Rate rate(10);
  while (!has_map && ros::ok()) {                   // expect-not: finding waits-for-ever "*the topic /map,*"
    ros::spinOnce();
    rate.sleep();
  }
  for (int i = 0; !has_pose && i < 10; ++i) {       // ten rounds at most
    ros::spinOnce();
    rate.sleep();
  }
  while (!has_pose) {                               // and a loop that is left otherwise
    ros::spinOnce();
    if (plan_pub.getNumSubscribers() > 0) break;
  }
  ros::topic::waitForMessage<std_msgs::Empty>("first", nh);  // expect: finding waits-for-ever "*the topic /first,*"
  ros::topic::waitForMessage<std_msgs::Empty>("soon_first", nh, ros::Duration(1.0));
  waitForAction();
  ros::spin();
}
