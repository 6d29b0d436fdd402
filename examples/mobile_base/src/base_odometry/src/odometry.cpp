#include <base_odometry/odometry.h>

#include <geometry_msgs/TransformStamped.h>

namespace base_odometry
{
Odometry::Odometry(ros::NodeHandle nh, ros::NodeHandle private_nh) : status_(private_nh, "odometry_status")
{
  loadParameters(private_nh);
  odom_pub_ = advertise<nav_msgs::Odometry>(nh, odom_topic_);
  ticks_sub_ = nh.subscribe<base_msgs::WheelTicks>("wheel_ticks", 10, &Odometry::onTicks, this);
  reset_server_ = private_nh.advertiseService("reset", &Odometry::onReset, this);
}

void Odometry::loadParameters(const ros::NodeHandle& private_nh)
{
  private_nh.param<std::string>("odom_topic", odom_topic_, "odom");
  private_nh.param<std::string>("frames/odom", odom_frame_, "odom");
  private_nh.param<std::string>("frames/base", base_frame_, "base_link");
  private_nh.getParam("ticks_per_meter", ticks_per_meter_);
  private_nh.param("publish_tf", publish_tf_, publish_tf_);
}

void Odometry::onTicks(const base_msgs::WheelTicksConstPtr& ticks)
{
  if (!has_ticks_)
  {
    last_ticks_ = *ticks;
    has_ticks_ = true;
    return;
  }
  const double left = (ticks->left - last_ticks_.left) / ticks_per_meter_;
  const double right = (ticks->right - last_ticks_.right) / ticks_per_meter_;
  last_ticks_ = *ticks;
  odom_.pose.pose.position.x += (left + right) / 2.0;
  publish(ticks->header.stamp);
}

bool Odometry::onReset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response)
{
  has_ticks_ = false;
  odom_ = nav_msgs::Odometry();
  status_.report(base_msgs::BaseStatus::OK, "reset");
  response.success = true;
  return true;
}

void Odometry::publish(const ros::Time& stamp)
{
  odom_.header.stamp = stamp;
  odom_.header.frame_id = odom_frame_;
  odom_.child_frame_id = base_frame_;
  odom_.pose.pose.orientation.w = 1.0;
  odom_pub_.publish(odom_);

  if (publish_tf_)
  {
    geometry_msgs::TransformStamped transform;
    transform.header = odom_.header;
    transform.child_frame_id = base_frame_;
    transform.transform.translation.x = odom_.pose.pose.position.x;
    transform.transform.rotation = odom_.pose.pose.orientation;
    broadcaster_.sendTransform(transform);
  }
}
}  // namespace base_odometry
