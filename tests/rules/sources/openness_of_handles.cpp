// Handles that code gets which was not seen; what gets none, and libraries that are known, leave the node closed.
//
// expect: open_at("ports", C, ["handed", "absent_map::MapServer"])
// expect: open_at("params", C, ["handed", "absent_map::load"])
// expect: Count = count : { open_at("ports", C, Reason) }, Count = 2
#include <absent_map/map_server.h>
#include <image_transport/image_transport.h>
#include <ros/ros.h>

int main(int argc, char** argv)
{
  ros::init(argc, argv, "mapper");
  ros::NodeHandle nh, private_nh("~");
  image_transport::ImageTransport transport(nh);
  absent_map::MapServer server(nh, private_nh);
  absent_map::Grid grid(3, 4);
  absent_map::load(grid, private_nh);
  absent_map::smooth(grid);
  ros::spin();
}
