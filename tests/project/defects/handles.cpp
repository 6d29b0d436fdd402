// What a handle makes of a name: its namespace, the node's own, neither for absolute ones; remappings replace whole names.
// expect: Count = count : { port([_, "publisher", _]) }, Count = 5
#include <ros/ros.h>
#include <std_msgs/String.h>

typedef std_msgs::String M;

int main(int argc, char** argv)
{
  ros::init(argc, argv, "handles");
  ros::NodeHandle ns("ns");
  ns.advertise<M>("topic", 1);  // expect: publisher ns/topic
  ros::NodeHandle own("~");
  own.advertise<M>("/topic", 1);  // expect: publisher /topic
  own.advertise<M>("own", 1);  // expect: publisher ~own
  ros::M_string remappings;
  remappings["odom"] = "pose";
  ros::NodeHandle remapped("", remappings);
  remapped.advertise<M>("odom", 1);  // expect: publisher pose
  remapped.advertise<M>("odometry", 1);  // expect: publisher odometry
}
