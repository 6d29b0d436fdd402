// A callback of a filter is a callback.
#include <message_filters/subscriber.h>
#include <tf2_ros/message_filter.h>
#include <tf2_ros/transform_listener.h>
#include <ros/ros.h>
#include <std_msgs/String.h>

typedef std_msgs::String M;

void cb(const std_msgs::StringConstPtr& message)
{
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "callbacks");
  ros::NodeHandle nh;
  message_filters::Subscriber<M> filter(nh, "filter", 1);  // expect: subscriber filter callback=cb
  filter.registerCallback(cb);
  tf2_ros::Buffer buffer;
  message_filters::Subscriber<M> inner(nh, "tf", 1);  // expect: subscriber tf callback=cb
  tf2_ros::MessageFilter<M> waiting(inner, buffer, "map", 1, nh);
  waiting.registerCallback(cb);
  ros::Subscriber bound = nh.subscribe<M>("bound", 1, boost::bind(cb, _1));  // expect: subscriber bound callback=cb
}
