// Names in namespaces: of handles, of the node, of parameters, and with parts that are not known.
//
// expect: N = count : { joined_text(_, _, _) }, N = 20
// expect: N = count : { one_parameter(_, _, _) }, N = 36
// expect: N = count : { name_parameter(_, _, _, _) }, N = 43
// expect: N = count : { resolved(_, _, _) }, N = 50
// expect: N = count : { joins(_, _, _) }, N = 8
// expect: N = count : { names_namespace(_, _) }, N = 8
// expect: N = count : { name_values(_, _, _, _, _, _) }, N = 5
// expect: N = count : { operand_values(_, _, _, _, _, _) }, N = 21
// expect: N = count : { call_namespace(_, _, _, _) }, N = 41
// expect: N = count : { port_in_namespace(_, _) }, N = 3
// expect: port_in_namespace([_, "subscriber", "/of_node"], "first")
// expect: port_in_namespace([_, "subscriber", "/pre"], "first")
// expect: port_in_namespace([_, "subscriber", "x/"], "inside")
// expect-only: subscriber
// expect-only: publisher
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <sstream>
#include <string>
#include <vector>

void onMessage(const std_msgs::Empty&)
{
}

// none of these texts is a name
std::string irrelevant(const std::string& text)
{
  ros::NodeHandle nh("~");
  ros::NodeHandle inner(nh, "unused");
  std::stringstream stream;
  stream << text << "/" << 2;
  return ros::names::append(nh.resolveName(text + "/a"), stream.str() + "/b") + std::to_string(2 * 3);
}

int main(int argc, char** argv)
{
  ros::M_string remappings;
  remappings["remapped"] = "/elsewhere";
  ros::init(remappings, "names");
  ros::NodeHandle nh, private_nh("~"), robot("robot"), arm(robot, "arm"), absolute("/abs"), slash("robot/"), empty(""), inside(robot, ""), same(robot), own(robot, "~own");
  std::vector<ros::Subscriber> subs;
  irrelevant("text");

  subs.push_back(nh.subscribe("/a", 1, onMessage));  // expect: subscriber /a
  subs.push_back(private_nh.subscribe("b", 1, onMessage));  // expect: subscriber ~b
  subs.push_back(robot.subscribe("c", 1, onMessage));  // expect: subscriber robot/c
  subs.push_back(arm.subscribe("d", 1, onMessage));  // expect: subscriber robot/arm/d
  subs.push_back(private_nh.subscribe("/e", 1, onMessage));  // expect: subscriber /e
  subs.push_back(robot.subscribe("~f", 1, onMessage));  // expect: subscriber ~f
  subs.push_back(robot.subscribe("~/g", 1, onMessage));  // expect: subscriber ~g
  subs.push_back(slash.subscribe("h", 1, onMessage));  // expect: subscriber robot/h
  subs.push_back(absolute.subscribe("i", 1, onMessage));  // expect: subscriber /abs/i
  subs.push_back(same.subscribe("j", 1, onMessage));  // expect: subscriber robot/j
  subs.push_back(own.subscribe("k", 1, onMessage));  // expect: subscriber ~own/k
  subs.push_back(empty.subscribe("empty", 1, onMessage));  // expect: subscriber empty
  subs.push_back(inside.subscribe("inside", 1, onMessage));  // expect: subscriber robot/inside
  subs.push_back(nh.subscribe("remapped", 1, onMessage));  // expect: subscriber /elsewhere

  subs.push_back(nh.subscribe(ros::names::append("append", "l"), 1, onMessage));  // expect: subscriber append/l
  subs.push_back(nh.subscribe(ros::this_node::getName() + "/m", 1, onMessage));  // expect: subscriber ~m
  subs.push_back(nh.subscribe(robot.resolveName("n"), 1, onMessage));  // expect: subscriber robot/n
  subs.push_back(nh.subscribe(private_nh.getNamespace() + "/o", 1, onMessage));  // expect: subscriber ~o
  subs.push_back(nh.subscribe(ros::names::resolve("p"), 1, onMessage));  // expect: subscriber p

  std::string prefix, suffix;
  private_nh.param<std::string>("prefix", prefix, "pre");
  private_nh.param<std::string>("suffix", suffix, "suf");
  ros::NodeHandle named(prefix);
  subs.push_back(nh.subscribe(prefix + "/q", 1, onMessage));  // expect: subscriber pre/q from_param=~prefix
  subs.push_back(nh.subscribe("q/" + suffix, 1, onMessage));  // expect: subscriber q/suf from_param=~suffix
  subs.push_back(nh.subscribe(prefix + "/" + suffix, 1, onMessage));  // expect: subscriber pre/suf from_param=~prefix
  subs.push_back(named.subscribe("r", 1, onMessage));  // expect: subscriber pre/r from_param=~prefix
  subs.push_back(named.subscribe(suffix, 1, onMessage));  // expect: subscriber pre/suf from_param=~prefix
  subs.push_back(named.subscribe("/s", 1, onMessage));  // expect: subscriber /s from_param=
  subs.push_back(named.subscribe("~" + suffix, 1, onMessage));  // expect: subscriber ~suf from_param=~suffix

  const std::string space = ros::this_node::getNamespace();
  subs.push_back(nh.subscribe(space + "of_node", 1, onMessage));  // expect: subscriber /of_node
  subs.push_back(nh.subscribe(space + "/" + prefix, 1, onMessage));  // expect: subscriber /pre
  subs.push_back(nh.subscribe("x" + space, 1, onMessage));  // expect: subscriber x/

  const std::string unknown = argv[1];
  ros::NodeHandle below(unknown);
  subs.push_back(nh.subscribe(unknown + "/t", 1, onMessage));  // expect: subscriber ?/t
  subs.push_back(nh.subscribe(unknown + "/t" + "/u", 1, onMessage));  // expect: subscriber ?/t/u
  subs.push_back(nh.subscribe("v/" + unknown, 1, onMessage));  // expect: subscriber ?
  subs.push_back(nh.subscribe(unknown + "/w" + unknown, 1, onMessage));  // expect: subscriber ?
  subs.push_back(nh.subscribe(unknown + unknown, 1, onMessage));  // expect: subscriber ?
  subs.push_back(nh.subscribe(unknown + "_x", 1, onMessage));  // expect: subscriber ?
  subs.push_back(nh.subscribe("y/" + std::string("/z"), 1, onMessage));  // expect: subscriber y/z
  subs.push_back(robot.subscribe(unknown + "/known", 1, onMessage));  // expect: subscriber ?/known
  subs.push_back(below.subscribe("below", 1, onMessage));  // expect: subscriber ?/below
  ros::spin();
}
