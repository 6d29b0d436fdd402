// What functions of libraries do is not known: an object that was given the map is asked for its answer, a cloud is filled by what is called for its effect.
//
// expect: port_flow([_, _, "/map"], [_, _, "/pose"], "data", "kept")
// expect: port_flow([_, _, "/scan"], [_, _, "/pose"], "data", "reactive")
// expect: Count = count : { port_flow(_, _, _, _) }, Count = 2
// expect-not: value_enters(_, _, _)
#include <aligner/aligner.h>
#include <geometry_msgs/Pose.h>
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>

static aligner::Aligner matcher;
static ros::Publisher pub;

void onMap(const sensor_msgs::PointCloud2::ConstPtr& map)
{
  aligner::Cloud cloud;
  aligner::convert(*map, cloud);
  matcher.setTarget(cloud);
}

void onScan(const sensor_msgs::PointCloud2::ConstPtr& scan)
{
  aligner::Cloud cloud;
  aligner::convert(*scan, cloud);
  aligner::Matrix found = matcher.align(cloud);
  geometry_msgs::Pose pose;
  pose.position.x = found(0, 3);
  pub.publish(pose);
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "localizer");
  ros::NodeHandle nh;
  pub = nh.advertise<geometry_msgs::Pose>("/pose", 1);
  ros::Subscriber map = nh.subscribe("/map", 1, onMap), scan = nh.subscribe("/scan", 1, onScan);
  ros::spin();
}
