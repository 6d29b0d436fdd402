// A loop whose condition is a local variable that holds whether the node lives, and one whose condition is another.
//
// expect: periodic beat hz=20
// expect-only: periodic
#include <ros/ros.h>
#include <std_msgs/Bool.h>

void count(ros::Publisher& pub)
{
  ros::Rate rate(5);
  bool more = pub.getTopic().empty();
  while (more) {
    pub.publish(std_msgs::Bool());
    more = false;
    rate.sleep();
  }
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "beat");
  ros::NodeHandle nh;
  ros::Publisher beat = nh.advertise<std_msgs::Bool>("beat", 1);
  ros::Publisher other = nh.advertise<std_msgs::Bool>("other", 1);
  count(other);
  ros::Rate rate(20);
  bool status = ros::ok();
  while (status) {
    ros::spinOnce();
    beat.publish(std_msgs::Bool());
    status = ros::ok();
    rate.sleep();
  }
}
