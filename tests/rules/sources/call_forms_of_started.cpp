// The server of tf2_ros is started when all is made.
//
// expect: action_server frames
// expect-not: starts_in_constructor(_, _, _)
#include <ros/ros.h>
#include <tf2_ros/buffer_server.h>

int main(int argc, char** argv) {
  ros::init(argc, argv, "buffers");
  tf2_ros::Buffer buffer;
  tf2_ros::BufferServer server(buffer, "frames");
  server.start();
  ros::spin();
}
