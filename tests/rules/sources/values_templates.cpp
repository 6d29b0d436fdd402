// Names that are members of what a template is made with, and calls in templates.
//
// expect: N = count : { member_of_instance(_, _, _) }, N = 5
// expect: N = count : { bound_type(_, _, _, _) }, N = 5
// expect: N = count : { of_other_instance(_, _, _) }, N = 2
// expect: N = count : { template_made_with(Type, Class), location(Class, _, _, _) }, N = 3
// expect: N = count : { variable_wanted(_) }, N = 7
// expect-only: subscriber
// expect: 14 = count : { plain_class(_) }
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <string>
#include <vector>

std::vector<ros::Subscriber> g_subs;

void onMessage(const std_msgs::Empty&)
{
}

struct Left
{
  static const std::string NAME;
  static const std::string FRAME;
  static std::string topic()
  {
    return "/left_topic";
  }
};
const std::string Left::NAME = "/left";
const std::string Left::FRAME = "left_frame";

struct Right
{
  static const std::string NAME;
  static const std::string FRAME;
  static std::string topic()
  {
    return "/right_topic";
  }
};
const std::string Right::NAME = "/right";
const std::string Right::FRAME = "right_frame";

struct Never
{
  static const std::string NAME;
};
const std::string Never::NAME = "/never";

template <class Side>
class Reader
{
public:
  void start(ros::NodeHandle& nh)
  {
    // expect: subscriber /left
    g_subs.push_back(nh.subscribe(Side::NAME, 1, onMessage));  // expect: subscriber /right
    // expect: subscriber /left_topic
    g_subs.push_back(nh.subscribe(Side::topic(), 1, onMessage));  // expect: subscriber /right_topic
    ROS_INFO_STREAM(Side::FRAME);
  }
};

template <class Number, class Side>
void subscribeTo(ros::NodeHandle& nh, Number queue)
{
  g_subs.push_back(nh.subscribe(Side::NAME, queue, onMessage));  // expect: subscriber /left queue=2
}

template <class Side>
void subscribeNever(ros::NodeHandle& nh)
{
  g_subs.push_back(nh.subscribe(Side::NAME, 1, onMessage));
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  Reader<Left> left;
  Reader<Right> right;
  left.start(nh);
  right.start(nh);
  subscribeTo<int, Left>(nh, 2);
  ros::spin();
}
