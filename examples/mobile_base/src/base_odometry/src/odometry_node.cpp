#include <base_odometry/odometry.h>

int main(int argc, char** argv)
{
  ros::init(argc, argv, "odometry");
  base_odometry::Odometry odometry(ros::NodeHandle(), ros::NodeHandle("~"));
  ros::spin();
  return 0;
}
