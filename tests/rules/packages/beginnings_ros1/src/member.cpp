#include <ros/ros.h>
#include <std_msgs/String.h>
class Talker {
public:
  void run(int argc, char **argv) {}
  ros::NodeHandle nh_;
};
int main(int argc, char **argv) {
  Talker talker;  // expect: finding library-started-late "/member uses roscpp before it initialises it"
  ros::init(argc, argv, "member");
  ros::Rate rate(0);  // expect: finding period-of-zero "/member makes a rate of zero times a second"
  while (ros::ok()) rate.sleep();
}
