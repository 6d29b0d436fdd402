// How texts come through functions, copies, containers, conditions and arithmetic; what cannot be told is told so.
//
// expect: N = count : { value(E, Context, Text, Parameter), call_role(Call, "name", E) }, N = 33
// expect: N = count : { value(E, Context, "?", Parameter), wanted(E) }, N = 46
// expect: N = count : { value_source(E, Source), wanted(E) }, N = 33
// expect: N = count : { recursive_call(_) }, N = 2
// expect: N = count : { recursive_return(_) }, N = 1
// expect: N = count : { own_parameter_use(_, _, _) }, N = 24
// expect: N = count : { captured_parameter_use(_, _, _) }, N = 0
// expect: N = count : { context_matters(_) }, N = 8
// expect: N = count : { called(_) }, N = 8
// expect: N = count : { makes(_, _) }, N = 1
// expect: N = count : { calculation_values(_, _, _, _, _, _) }, N = 2
// expect: N = count : { assigned_value(D, V, E), wanted(E) }, N = 16
// expect: N = count : { inserted(_, _, _) }, N = 24
// expect: N = count : { placeholder(_, _, _) }, N = 12
// expect: N = count : { format_filled(_, _, _, _, _) }, N = 5
// expect-only: subscriber
// expect: subscriber /if_parameter
// expect: subscriber /default_argument
// expect: subscriber /by_function
// expect: subscriber /recursive
// expect: subscriber ?
// expect: 28 = count : { as_given(_, _, _) }
#include <boost/format.hpp>
#include <cstdio>
#include <memory>
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <string>
#include <vector>

struct Name
{
  Name(const std::string& text) : text_(text)
  {
  }
  std::string text_;
};

ros::NodeHandle* g_nh;
std::vector<ros::Subscriber> g_subs;

void onMessage(const std_msgs::Empty&)
{
}

void subscribeIf(bool on, const std::string& name = "/default_argument")
{
  if (on)
    g_subs.push_back(g_nh->subscribe(name, 1, onMessage));
}

std::string below(const std::string& name)
{
  return "/below/" + name;
}

std::string constant()
{
  return "/constant";
}

std::string deeper(const std::string& name, int depth)
{
  return depth == 0 ? name : deeper(name + "/deeper", depth - 1);
}

void again(const std::string& name, int times)
{
  g_subs.push_back(g_nh->subscribe(name, 1, onMessage));
  if (times > 0)
    again(name, times - 1);
}

void fill(std::string& name, const std::string& with)
{
  name = with;
}

// no name comes from here
double irrelevant(const std::string& name, double scale)
{
  std::vector<std::string> names{"/x", "/y"};
  names[0] = below(name).substr(1);
  names.push_back(scale > 1 ? "big" : "small");
  const double half = -scale / 2 * 3;
  std::string text = (boost::format("%s %d") % name % 2).str();
  fill(text, name);
  char buffer[10];
  snprintf(buffer, 10, "%s", text.c_str());
  return half + names.size();
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh, private_nh("~");
  g_nh = &nh;
  irrelevant("name", 2);

  subscribeIf(private_nh.hasParam("camera"), "/if_parameter");
  subscribeIf(false, "/if_false");
  subscribeIf(true);
  std::string filled;
  fill(filled, "/by_function");
  subscribeIf(true, filled);
  again("/recursive", 3);

  g_subs.push_back(nh.subscribe(below("a"), 1, onMessage));  // expect: subscriber /below/a
  g_subs.push_back(nh.subscribe(below(below("b")), 1, onMessage));  // expect: subscriber /below/below/b
  g_subs.push_back(nh.subscribe(constant(), 1, onMessage));  // expect: subscriber /constant
  g_subs.push_back(nh.subscribe(deeper("/deep", 2), 1, onMessage));  // expect: subscriber /deep
  g_subs.push_back(nh.subscribe(argc > 1 ? "/this" : argc > 2 ? "/that" : "/other", 1, onMessage));  // expect: subscriber /this
  // expect: subscriber /that
  // expect: subscriber /other
  g_subs.push_back(nh.subscribe(argc > 1 ? argv[1] : nullptr, 1, onMessage));  // expect: subscriber ?

  const Name name("/wrapped");
  const Name copy(name);
  g_subs.push_back(nh.subscribe(copy.text_, 1, onMessage));  // expect: subscriber /wrapped
  const std::vector<std::string> names{"/left", "/right"};
  for (const std::string& each : names)
    g_subs.push_back(nh.subscribe(each, 1, onMessage));  // expect: subscriber /left
  // expect: subscriber /right
  std::vector<std::string> filled_names(2);
  filled_names[0] = "/indexed";
  g_subs.push_back(nh.subscribe(filled_names[1], 1, onMessage));  // expect: subscriber /indexed
  std::shared_ptr<ros::NodeHandle> shared = std::make_shared<ros::NodeHandle>("shared");
  g_subs.push_back(shared->subscribe("a", 1, onMessage));  // expect: subscriber shared/a
  std::unique_ptr<ros::NodeHandle> unique(new ros::NodeHandle(nh, "unique"));
  g_subs.push_back((*unique).subscribe("a", 1, onMessage));  // expect: subscriber unique/a
  std::string moved = std::move(filled);
  moved += static_cast<std::string>("/moved");
  g_subs.push_back(nh.subscribe(moved.c_str(), 1, onMessage));  // expect: subscriber /by_function/moved

  g_subs.push_back(nh.subscribe(boost::str(boost::format("/format_%1%_%2%") % "a" % 2), 1, onMessage));  // expect: subscriber /format_a_2
  g_subs.push_back(nh.subscribe((boost::format("/%s/%s") % argv[1] % "known").str(), 1, onMessage));  // expect: subscriber ?/known
  g_subs.push_back(nh.subscribe((boost::format("/%s_%s") % argv[1] % "known").str(), 1, onMessage));  // expect: subscriber ?
  const size_t count = 1;
  g_subs.push_back(nh.subscribe((boost::format("%s_%s") % argv[1] % 1).str() + "/after", 1, onMessage));  // expect: subscriber ?/after
  char buffer[40];
  snprintf(buffer, 40, "/%s/%i/%lu/%zu", "many", 1, 2ul, count);
  g_subs.push_back(nh.subscribe(buffer, 1, onMessage));  // expect: subscriber /many/1/2/1
  int queue = private_nh.param("queue", 10);
  g_subs.push_back(nh.subscribe("/queue", queue * 2, onMessage));  // expect: subscriber /queue queue=20
  g_subs.push_back(nh.subscribe("/numbered" + std::to_string(3 - 1), queue / 2, onMessage));  // expect: subscriber /numbered2
  ros::spin();
}
