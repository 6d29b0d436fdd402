// Texts of names by the rarer ways: bound arguments, chosen by a default, sums and formats.
//
// expect: subscriber /bound_7
// expect: subscriber /thread_name
// expect: subscriber /taken
// expect-not: subscriber /not_taken
// expect: subscriber /captured
// expect: subscriber /format/one
// expect: subscriber ?/two
// expect: subscriber /number_3
// expect: subscriber /resolved
// expect: value(E, _, "5", _), operator(E, "-")
// expect-not: _called_inside(_, _); _generic(_, _)
// expect: 9 = count : { name_parameter(_, _, _, _) }
#include <boost/format.hpp>
#include <functional>
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <string>
#include <thread>

void onMessage(const std_msgs::Empty&)
{
}

ros::NodeHandle* g_nh;
ros::Subscriber g_sub[9];

void subscribeBound(const std::string& name)
{
  g_sub[0] = g_nh->subscribe(name, 1, onMessage);
}

void subscribeInThread(std::string name)
{
  g_sub[1] = g_nh->subscribe(name, 1, onMessage);
}

void subscribeCaptured(const std::string& name)
{
  auto subscribe = [&name]() { g_sub[2] = g_nh->subscribe(name, 1, onMessage); };
  subscribe();
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh, private_nh("~");
  g_nh = &nh;
  auto bound = std::bind(subscribeBound, "/bound_7");
  bound();
  std::thread thread(subscribeInThread, "/thread_name");
  subscribeCaptured("/captured");

  bool simulated;
  private_nh.param("simulated", simulated, false);
  g_sub[3] = nh.subscribe(simulated ? "/not_taken" : "/taken", 1, onMessage);

  g_sub[4] = nh.subscribe((boost::format("/format/%s") % "one").str(), 1, onMessage);
  g_sub[5] = nh.subscribe((boost::format("%s/two") % argv[1]).str(), 1, onMessage);

  const int number = 3;
  g_sub[6] = nh.subscribe("/number_" + std::to_string(number), 8 - number, onMessage);
  g_sub[7] = nh.subscribe(ros::names::resolve("/resolved"), 1, onMessage);
  ros::spin();
}
