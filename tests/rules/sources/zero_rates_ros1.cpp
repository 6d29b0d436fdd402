// A rate of a parameter that may not be zero, and one that is asked about first.
//
// expect: refuses_number(_, "~hz", "value", "==", "0")
// expect: 1 = count : { refuses_number(_, _, _, _, _) }
#include <ros/ros.h>

int main(int argc, char **argv) {
  ros::init(argc, argv, "pump");
  ros::NodeHandle nh("~");
  double hz, other;
  nh.param("hz", hz, 10.0);
  nh.param("other", other, 10.0);
  if (other < 1.0) other = 1.0;
  ros::Rate second(other);
  ros::Rate rate(hz);
  while (ros::ok()) {
    ros::spinOnce();
    rate.sleep();
  }
}
