#include <memory>

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/TransformStamped.h>
#include <message_filters/subscriber.h>
#include <ros/ros.h>
#include <tf2_geometry_msgs/tf2_geometry_msgs.h>
#include <tf2_ros/buffer_client.h>
#include <tf2_ros/buffer_server.h>
#include <tf2_ros/message_filter.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <tf2_ros/transform_broadcaster.h>
#include <tf2_ros/transform_listener.h>

class Docking
{
public:
  Docking() : dock_(nh_, "dock_pose", 2), in_map_(dock_, buffer_, "map", 5, nh_), server_(buffer_, "tf_server", false), remote_("/fleet/tf_server")
  {
    listener_.reset(new tf2_ros::TransformListener(buffer_));
    in_map_.registerCallback(&Docking::onDock, this);

    geometry_msgs::TransformStamped laser;
    laser.header.frame_id = "base_link";
    laser.child_frame_id = "laser";
    fixed_.sendTransform(laser);
    server_.start();
  }

private:
  void onDock(const geometry_msgs::PoseStampedConstPtr& pose)
  {
    geometry_msgs::TransformStamped dock = buffer_.lookupTransform("map", "base_link", ros::Time(0));
    dock.header.frame_id = "map";
    dock.child_frame_id = "dock";
    moving_.sendTransform(dock);
    const geometry_msgs::PoseStamped local = buffer_.transform(*pose, "base_link");
    ROS_INFO("dock at %f", local.pose.position.x);
  }

  ros::NodeHandle nh_;
  tf2_ros::Buffer buffer_;
  std::unique_ptr<tf2_ros::TransformListener> listener_;
  tf2_ros::TransformBroadcaster moving_;
  tf2_ros::StaticTransformBroadcaster fixed_;
  message_filters::Subscriber<geometry_msgs::PoseStamped> dock_;
  tf2_ros::MessageFilter<geometry_msgs::PoseStamped> in_map_;
  tf2_ros::BufferServer server_;
  tf2_ros::BufferClient remote_;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "docking");
  Docking docking;
  ros::spin();
  return 0;
}
