// A subscription that ends with an inner block of the program, and one in a block that lets callbacks run.
//
// expect: variable_ends(V, 21), variable_name(V, "gone")
// expect: never_works(C), location(C, _, 20, _)
// expect: 1 = count : { never_works(_) }
// expect: port_callback([_, "subscriber", "kept"], _)
#include <ros/ros.h>
#include <std_msgs/Empty.h>

static ros::Publisher g_out;

void onIn(const std_msgs::Empty& msg) { g_out.publish(msg); }

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  g_out = nh.advertise<std_msgs::Empty>("out", 1);
  ros::Subscriber in = nh.subscribe("in", 1, onIn);
  {
    ros::Subscriber gone = nh.subscribe("gone", 1, onIn);
  }
  {
    ros::Subscriber kept = nh.subscribe("kept", 1, onIn);
    ros::spinOnce();
  }
  ros::spin();
}
