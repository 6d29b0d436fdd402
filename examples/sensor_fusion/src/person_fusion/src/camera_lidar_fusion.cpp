// Pairs images with point clouds of about the same time and looks for persons in both.
#include <memory>
#include <string>

#include <boost/bind.hpp>
#include <fusion_msgs/Persons.h>
#include <image_transport/image_transport.h>
#include <image_transport/subscriber_filter.h>
#include <message_filters/subscriber.h>
#include <message_filters/sync_policies/approximate_time.h>
#include <message_filters/synchronizer.h>
#include <ros/ros.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_msgs/Float32.h>
#include <tf/transform_listener.h>

class CameraLidarFusion
{
  typedef message_filters::sync_policies::ApproximateTime<sensor_msgs::Image, sensor_msgs::CameraInfo, sensor_msgs::PointCloud2>
      SyncPolicy;
  typedef message_filters::Synchronizer<SyncPolicy> Sync;

public:
  CameraLidarFusion() : pnh_("~"), transport_(nh_)
  {
    std::string camera;
    pnh_.param<std::string>("camera", camera, "front");
    pnh_.param("sync_queue", sync_queue_, 10);
    pnh_.param<std::string>("target_frame", target_frame_, "base_link");

    image_sub_.subscribe(transport_, camera + "/image_rect", 5);
    info_sub_.subscribe(nh_, camera + "/camera_info", 5);
    cloud_sub_.subscribe(nh_, "lidar/points", 5);
    sync_.reset(new Sync(SyncPolicy(sync_queue_), image_sub_, info_sub_, cloud_sub_));
    sync_->registerCallback(boost::bind(&CameraLidarFusion::onSensors, this, _1, _2, _3));

    overlay_pub_ = transport_.advertise("overlay", 1);
    persons_pub_ = nh_.advertise<fusion_msgs::Persons>("persons", 10);
    rate_pub_ = pnh_.advertise<std_msgs::Float32>("rate", 1);
    rate_timer_ = nh_.createTimer(ros::Duration(2.0), &CameraLidarFusion::onRateTimer, this);
  }

private:
  void onSensors(const sensor_msgs::ImageConstPtr& image, const sensor_msgs::CameraInfoConstPtr& info,
                 const sensor_msgs::PointCloud2ConstPtr& cloud)
  {
    ++pairs_;
    tf::StampedTransform transform;
    try
    {
      listener_.lookupTransform(target_frame_, cloud->header.frame_id, cloud->header.stamp, transform);
    }
    catch (const tf::TransformException& error)
    {
      ROS_WARN_THROTTLE(5.0, "%s", error.what());
      return;
    }

    fusion_msgs::Persons persons;
    persons.header.stamp = image->header.stamp;
    persons.header.frame_id = target_frame_;
    detect(*image, *info, *cloud, transform, persons);
    persons_pub_.publish(persons);

    if (overlay_pub_.getNumSubscribers() > 0)
      overlay_pub_.publish(image);
  }

  void detect(const sensor_msgs::Image& image, const sensor_msgs::CameraInfo&, const sensor_msgs::PointCloud2& cloud,
              const tf::Transform& transform, fusion_msgs::Persons& persons)
  {
    if (image.data.empty() || cloud.data.empty())
      return;
    const tf::Vector3 position = transform * tf::Vector3(1.0, 0.0, 0.0);
    fusion_msgs::Person person;
    person.position.x = position.x();
    person.position.y = position.y();
    persons.persons.push_back(person);
  }

  void onRateTimer(const ros::TimerEvent& event)
  {
    if (event.last_real.isZero())
      return;
    std_msgs::Float32 rate;
    rate.data = pairs_ / (event.current_real - event.last_real).toSec();
    pairs_ = 0;
    rate_pub_.publish(rate);
  }

  ros::NodeHandle nh_;
  ros::NodeHandle pnh_;
  image_transport::ImageTransport transport_;
  image_transport::SubscriberFilter image_sub_;
  message_filters::Subscriber<sensor_msgs::CameraInfo> info_sub_;
  message_filters::Subscriber<sensor_msgs::PointCloud2> cloud_sub_;
  std::unique_ptr<Sync> sync_;
  tf::TransformListener listener_;

  image_transport::Publisher overlay_pub_;
  ros::Publisher persons_pub_;
  ros::Publisher rate_pub_;
  ros::Timer rate_timer_;

  int sync_queue_;
  std::string target_frame_;
  int pairs_ = 0;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "camera_lidar_fusion");
  CameraLidarFusion fusion;
  ros::MultiThreadedSpinner(2).spin();
  return 0;
}
