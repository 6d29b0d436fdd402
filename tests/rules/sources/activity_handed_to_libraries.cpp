// Functions that a library runs later, where the component lets it: handlers of asio, and what a filter hands on.
//
// expect: runs_later(C, F), function_name(F, "onRead")
// expect: feeds_filter(C, F), function_name(F, "onFiltered")
// expect: Count = count : { enters(C, F), function_name(F, "onRead") }, Count = 1
// expect: reactive /in -> /filtered may
// expect: periodic /read 10 Hz
// expect-not: reactive /in -> /read
#include <boost/asio.hpp>
#include <message_filters/pass_through.h>
#include <ros/ros.h>
#include <std_msgs/String.h>

ros::Publisher g_read_pub, g_filtered_pub;
message_filters::PassThrough<std_msgs::String> g_filter;

void onRead(const boost::system::error_code&, size_t)
{
  g_read_pub.publish(std_msgs::String());
}

void onFiltered(const std_msgs::StringConstPtr& message)
{
  g_filtered_pub.publish(message);
}

void onIn(const std_msgs::StringConstPtr& message)
{
  g_filter.add(message);
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  g_read_pub = nh.advertise<std_msgs::String>("/read", 1);
  g_filtered_pub = nh.advertise<std_msgs::String>("/filtered", 1);
  g_filter.registerCallback(onFiltered);
  ros::Subscriber sub = nh.subscribe("/in", 1, onIn);
  boost::asio::io_service service;
  boost::asio::serial_port port(service);
  char buffer[8];
  port.async_read_some(boost::asio::buffer(buffer), onRead);
  ros::Rate rate(10);
  while (ros::ok())
  {
    service.poll();
    ros::spinOnce();
    rate.sleep();
  }
}
