// A static variable is one for all objects of a class, each of which changes it; a member is another for each.
//
// expect: changed_by_several(V), variable_name(V, "common_")
// expect: 1 = count : { changed_by_several(_) }
#include <ros/ros.h>
#include <std_msgs/Empty.h>

struct Half
{
  explicit Half(ros::NodeHandle& nh, const std::string& name) : out_(nh.advertise<std_msgs::Empty>(name, 1))
  {
    timer_ = nh.createTimer(ros::Duration(0.1), &Half::tick, this);
  }
  void tick(const ros::TimerEvent&)
  {
    common_ = !common_;
    own_ = !own_;
    if (common_ && own_) out_.publish(std_msgs::Empty());
  }
  ros::Publisher out_;
  ros::Timer timer_;
  static bool common_;
  bool own_ = false;
};

bool Half::common_ = false;

int main(int argc, char** argv)
{
  ros::init(argc, argv, "halves");
  ros::NodeHandle nh;
  Half left(nh, "left");
  Half right(nh, "right");
  ros::spin();
}
