// Broadcasts where the sensors are mounted, from parameters.
#include <string>
#include <vector>

#include <geometry_msgs/TransformStamped.h>
#include <ros/ros.h>
#include <tf2_ros/static_transform_broadcaster.h>

namespace
{
geometry_msgs::TransformStamped mount(const std::string& sensor, const std::vector<double>& offset)
{
  geometry_msgs::TransformStamped transform;
  transform.header.stamp = ros::Time::now();
  transform.header.frame_id = "base_link";
  transform.child_frame_id = sensor;
  if (offset.size() == 3)
  {
    transform.transform.translation.x = offset[0];
    transform.transform.translation.y = offset[1];
    transform.transform.translation.z = offset[2];
  }
  transform.transform.rotation.w = 1.0;
  return transform;
}
}  // namespace

int main(int argc, char** argv)
{
  ros::init(argc, argv, "sensor_frames");
  ros::NodeHandle pnh("~");
  tf2_ros::StaticTransformBroadcaster broadcaster;

  std::vector<double> camera_offset, lidar_offset;
  if (!pnh.getParam("camera_offset", camera_offset))
    ROS_WARN("no camera_offset, the camera is assumed at the origin");
  if (pnh.hasParam("lidar_offset"))
    pnh.getParam("lidar_offset", lidar_offset);

  broadcaster.sendTransform({ mount("camera", camera_offset), mount("lidar", lidar_offset) });
  ros::spin();
  return 0;
}
