// Follows persons over time, in the map frame, and broadcasts the nearest one as a frame.
#include <string>

#include <fusion_msgs/Persons.h>
#include <geometry_msgs/PointStamped.h>
#include <geometry_msgs/TransformStamped.h>
#include <message_filters/subscriber.h>
#include <ros/ros.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/message_filter.h>
#include <tf2_ros/transform_broadcaster.h>
#include <tf2_ros/transform_listener.h>

class PersonTracker
{
public:
  PersonTracker()
    : listener_(buffer_), persons_sub_(nh_, "persons", 10), filter_(persons_sub_, buffer_, "map", 10, nh_)
  {
    filter_.registerCallback(&PersonTracker::onPersons, this);
    nearest_pub_ = nh_.advertise<geometry_msgs::PointStamped>("nearest_person", 1);

    ros::NodeHandle pnh("~");
    double timeout = 3.0;
    pnh.getParam("timeout", timeout);
    timeout_ = ros::Duration(timeout);
    timer_ = nh_.createWallTimer(ros::WallDuration(0.1), &PersonTracker::onTimer, this);
  }

private:
  void onPersons(const fusion_msgs::PersonsConstPtr& persons)
  {
    if (persons->persons.empty())
      return;
    nearest_.header = persons->header;
    nearest_.point = persons->persons.front().position;
    tracking_ = true;
    nearest_pub_.publish(nearest_);
  }

  void onTimer(const ros::WallTimerEvent&)
  {
    if (!tracking_)
      return;
    if (ros::Time::now() - nearest_.header.stamp > timeout_)
    {
      tracking_ = false;
      return;
    }
    geometry_msgs::TransformStamped transform;
    transform.header = nearest_.header;
    transform.child_frame_id = "nearest_person";
    transform.transform.translation.x = nearest_.point.x;
    transform.transform.translation.y = nearest_.point.y;
    transform.transform.rotation.w = 1.0;
    broadcaster_.sendTransform(transform);
  }

  ros::NodeHandle nh_;
  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_;
  tf2_ros::TransformBroadcaster broadcaster_;
  message_filters::Subscriber<fusion_msgs::Persons> persons_sub_;
  tf2_ros::MessageFilter<fusion_msgs::Persons> filter_;
  ros::Publisher nearest_pub_;
  ros::WallTimer timer_;

  ros::Duration timeout_;
  geometry_msgs::PointStamped nearest_;
  bool tracking_ = false;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "person_tracker");
  PersonTracker tracker;
  ros::spin();
  return 0;
}
