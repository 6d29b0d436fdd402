#include <ros/ros.h>
#include <sensor_msgs/Range.h>
#include <std_msgs/Bool.h>

ros::Publisher g_obstacle_pub;
double g_min_distance = 0.5;

void onRange(const sensor_msgs::Range::ConstPtr& range)
{
  std_msgs::Bool obstacle;
  obstacle.data = range->range < g_min_distance;
  g_obstacle_pub.publish(obstacle);
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "obstacle_detector");
  ros::NodeHandle nh;
  ros::param::param("~min_distance", g_min_distance, 0.5);
  g_obstacle_pub = nh.advertise<std_msgs::Bool>("obstacle_ahead", 1);
  ros::Subscriber range = nh.subscribe("sonar", 1, onRange);
  ros::spin();
  return 0;
}
