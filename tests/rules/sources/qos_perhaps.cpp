// A queue that may have another size, which is not known, has none that is.
//
// expect: publisher perhaps std_msgs/Bool
// expect: publisher surely std_msgs/Bool queue=4
// expect-not: port_queue([_, _, "perhaps"], _)
#include <cstdlib>
#include <ros/ros.h>
#include <std_msgs/Bool.h>

int main(int argc, char ** argv)
{
  ros::init(argc, argv, "queues");
  ros::NodeHandle nh;
  int size = 4;
  ros::Publisher surely = nh.advertise<std_msgs::Bool>("surely", size);
  if (argc > 1) {
    size = std::atoi(argv[1]);
  }
  ros::Publisher perhaps = nh.advertise<std_msgs::Bool>("perhaps", size);
  ros::spin();
}
