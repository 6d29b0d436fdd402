// The server of tf2_ros, whose versions differ in what they do without auto_start; nothing calls start().
//
// expect: 2 = count : { starts_in_constructor(_, _, _) }
// expect: starts_in_constructor(S, S, "open"), port([S, _, "left"])
// expect: starts_in_constructor(S, S, "told"), port([S, _, "flag"])
#include <ros/ros.h>
#include <tf2_ros/buffer_server.h>

int main(int argc, char** argv) {
  ros::init(argc, argv, "buffers");
  tf2::Buffer buffer;
  tf2_ros::BufferServer left(buffer, "left");
  tf2::BufferServer flag(buffer, "flag", true);
  tf2_ros::BufferServer off(buffer, "off", false);
  ros::spin();
}
