// One callback for two synchronised inputs of different types, and a transform that is looked up: each has its own part in what is sent.
//
// expect: port_flow([_, _, "/image"], [_, _, "/mark"], "data", "reactive")
// expect: port_flow([_, _, "/info"], [_, _, "/mark"], "control", "reactive")
// expect: port_flow([_, "tf_listener", _], [_, _, "/mark"], "data", "kept")
// expect: synchronised([_, _, "/image"], [_, _, "/info"])
// expect-not: _generic_type(_, _); joins(_, _, _); _relative(_); _off_connection(_, _); parameter_operand_type(_, _); _value_of_renewal(_); calls_as_named(_)
#include <geometry_msgs/PointStamped.h>
#include <message_filters/subscriber.h>
#include <message_filters/time_synchronizer.h>
#include <ros/ros.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <tf/transform_listener.h>

class Marker
{
public:
  Marker() : image_(nh_, "/image", 1), info_(nh_, "/info", 1), sync_(image_, info_, 10)
  {
    pub_ = nh_.advertise<geometry_msgs::PointStamped>("/mark", 1);
    sync_.registerCallback(boost::bind(&Marker::onBoth, this, _1, _2));
  }

private:
  void onBoth(const sensor_msgs::ImageConstPtr& image, const sensor_msgs::CameraInfoConstPtr& info)
  {
    tf::StampedTransform transform;
    listener_.lookupTransform("map", "camera", ros::Time(0), transform);
    geometry_msgs::PointStamped mark;
    mark.point.x = transform.getOrigin().x();
    mark.point.y = image->width;
    if (info->binning_x > 0)
      pub_.publish(mark);
  }

  ros::NodeHandle nh_;
  tf::TransformListener listener_;
  message_filters::Subscriber<sensor_msgs::Image> image_;
  message_filters::Subscriber<sensor_msgs::CameraInfo> info_;
  message_filters::TimeSynchronizer<sensor_msgs::Image, sensor_msgs::CameraInfo> sync_;
  ros::Publisher pub_;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "marker");
  Marker marker;
  ros::spin();
}
