// What hints.dl says of these places is so, whatever the source says.
//
// expect: N = count : { hinted_value(_, _) }, N = 17
// expect: N = count : { hinted(_) }, N = 16
// expect: N = count : { hinted_rate(_, _) }, N = 2
// expect: N = count : { hinted_type(_, _) }, N = 1
// expect: N = count : { hint_unused(_, _) }, N = 3
// expect: N = count : { value(E, Context, Text, Parameter), hinted(E) }, N = 17
// expect-only: subscriber
// expect-only: publisher
// expect-only: periodic
#include <ros/ros.h>
#include <std_msgs/Int32.h>
#include <string>
#include <utility>
#include <vector>

std::vector<ros::Subscriber> g_subs;
ros::Publisher g_pub, g_global;
std::string g_name = "/global";
std::string g_argument;

void onMessage(const std_msgs::Int32&)
{
}

void onTimer(const ros::TimerEvent&)
{
  g_pub.publish(std_msgs::Int32());
}

std::string nameOf(int number)
{
  return number > 1 ? "/many" : "/one";
}

void subscribe(ros::NodeHandle& nh, const std::string& name)
{
  g_subs.push_back(nh.subscribe(name, 1, onMessage));  // expect: subscriber /passed
}

ros::Subscriber g_early = ros::NodeHandle().subscribe(g_argument, 1, onMessage);  // expect: subscriber /early

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh, private_nh("~");
  std::string local = "/local", text = "text";
  std::pair<std::string, int> pair("/pair", 1);

  g_subs.push_back(nh.subscribe(argv[1], 1, onMessage));  // expect: subscriber /literal
  g_subs.push_back(nh.subscribe("/joined/" + text, 1, onMessage));  // expect: subscriber /whole
  g_subs.push_back(nh.subscribe(local, 1, onMessage));  // expect: subscriber /variable
  g_subs.push_back(nh.subscribe(g_name, 1, onMessage));  // expect: subscriber /outer
  g_subs.push_back(nh.subscribe(nameOf(2), 1, onMessage));  // expect: subscriber /returned
  g_subs.push_back(nh.subscribe(pair.first, 1, onMessage));  // expect: subscriber /part
  g_subs.push_back(nh.subscribe(private_nh.param<std::string>("topic", "/default"), 1, onMessage));  // expect: subscriber /parameter
  g_subs.push_back(nh.subscribe(ros::this_node::getNamespace(), 1, onMessage));  // expect: subscriber /namespace
  g_subs.push_back(nh.subscribe(private_nh.resolveName("name"), 1, onMessage));  // expect: subscriber /resolved
  g_subs.push_back(nh.subscribe(text.substr(1), 2 - 3, onMessage));  // expect: subscriber /cut queue=7
  // expect: subscriber /first
  g_subs.push_back(nh.subscribe(argv[2], 1, onMessage));  // expect: subscriber /second
  g_subs.push_back(ros::NodeHandle(argv[3]).subscribe("below", 1, onMessage));  // expect: subscriber robot/below
  subscribe(nh, "/unhinted");

  g_pub = nh.advertise<std_msgs::Int32>("/out", 1);  // expect: publisher /out std_msgs/Header
  // expect: periodic /out 4 Hz
  ros::Timer timer = nh.createTimer(ros::Duration(atof(argv[4])), onTimer);
  ros::Rate rate(atof(argv[5]));
  while (ros::ok())
  {
    g_pub.publish(std_msgs::Int32());
    // expect: periodic /out 25 Hz
    rate.sleep();
  }
}
