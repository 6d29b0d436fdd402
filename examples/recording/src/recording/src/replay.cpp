#include <string>
#include <vector>

#include <boost/foreach.hpp>
#include <ros/ros.h>
#include <rosbag/bag.h>
#include <rosbag/player.h>
#include <rosbag/view.h>
#include <std_msgs/Float64.h>

int main(int argc, char** argv)
{
  ros::init(argc, argv, "replay");
  ros::NodeHandle nh;

  rosbag::Bag bag("levels.bag");
  std::vector<std::string> topics;
  topics.push_back("/level");
  rosbag::View view(bag, rosbag::TopicQuery(topics));
  ros::Publisher level = nh.advertise<std_msgs::Float64>("level", 1);
  BOOST_FOREACH (rosbag::MessageInstance const instance, view)
  {
    const std_msgs::Float64::ConstPtr message = instance.instantiate<std_msgs::Float64>();
    if (message)
    {
      level.publish(message);
    }
  }

  rosbag::PlayerOptions options;
  options.bags.push_back("rest.bag");
  rosbag::Player player(options);
  player.publish();
  return 0;
}
