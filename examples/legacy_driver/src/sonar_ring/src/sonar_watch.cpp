#include <map>
#include <string>
#include <vector>

#include <boost/bind.hpp>
#include <ros/ros.h>
#include <sensor_msgs/Range.h>
#include <std_msgs/Bool.h>
#include <std_msgs/Float32.h>

namespace
{
struct Watch
{
  float nearest = 100.0f;
  std::map<std::string, ros::Time> last;
};

void onSide(const sensor_msgs::RangeConstPtr& msg, Watch* watch, const std::string& side)
{
  watch->last[side] = msg->header.stamp;
}
}  // namespace

int main(int argc, char** argv)
{
  ros::init(argc, argv, "sonar_watch");
  ros::NodeHandle nh;
  Watch watch;

  ros::Publisher nearest_pub = nh.advertise<std_msgs::Float32>("nearest", 1);
  ros::Publisher blind_pub = nh.advertise<std_msgs::Bool>("blind", 1, true);

  ros::Subscriber range_sub = nh.subscribe<sensor_msgs::Range>("range", 50, [&watch](const sensor_msgs::RangeConstPtr& msg) {
    if (msg->range > 0.0f && msg->range < watch.nearest)
      watch.nearest = msg->range;
  });

  const std::vector<std::string> sides = { "front", "left", "right", "rear" };
  std::vector<ros::Subscriber> side_subs;
  for (const auto& side : sides)
    side_subs.push_back(nh.subscribe<sensor_msgs::Range>("range_" + side, 10, boost::bind(onSide, _1, &watch, side)));

  double rate = 1.0;
  ros::param::get("~rate", rate);
  ros::Timer timer = nh.createTimer(ros::Duration(1.0 / rate), [&](const ros::TimerEvent&) {
    std_msgs::Float32 nearest;
    nearest.data = watch.nearest;
    nearest_pub.publish(nearest);
    watch.nearest = 100.0f;

    std_msgs::Bool blind;
    blind.data = watch.last.size() < sides.size();
    blind_pub.publish(blind);
  });

  ros::spin();
  return 0;
}
