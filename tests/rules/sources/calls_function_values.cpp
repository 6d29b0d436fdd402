// Functions that are values: through pointers, braces, containers, pairs, fields and casts.
//
// expect: reactive /in -> /out
// expect: Count = count : { calls(C, F), function_name(F, Name), contains("by", Name) }, Count = 7
// expect: calls(_, F), function_name(F, "byPointer")
// expect: calls(_, F), function_name(F, "byAddress")
// expect: calls(_, F), function_name(F, "byList")
// expect: calls(_, F), function_name(F, "byElement")
// expect: calls(_, F), function_name(F, "byPair")
// expect: calls(_, F), function_name(F, "byField")
// expect: calls(_, F), function_name(F, "byCast")
// expect-not: parameter_operand_type(_, _); given_to_field(_, _, _); _held_itself(_, _, _); flow_variable(_, _, _)
// expect-not: field_made(_, _)
#include <functional>
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <utility>
#include <vector>

ros::Publisher g_pub;

void byPointer()
{
  g_pub.publish(std_msgs::Empty());
}

void byAddress()
{
}

void byList()
{
}

void byElement()
{
}

void byPair()
{
}

void byField()
{
}

void byCast()
{
}

struct Runner
{
  Runner(std::function<void()> run) : run_(run)
  {
  }
  std::function<void()> run_;
};

// gives what it runs, but does not run itself
void byNobody()
{
}

void neverCalled()
{
  Runner runner(byNobody);
}

void onMessage(const std_msgs::Empty&)
{
  void (*pointer)() = byPointer;
  (*pointer)();

  void (*address)() = &byAddress;
  address();

  std::function<void()> list[] = {byList};
  for (auto& each : list)
    each();

  std::vector<std::function<void()>> elements;
  elements.push_back(byElement);
  elements.front()();

  std::pair<int, std::function<void()>> pair = std::make_pair(1, byPair);
  pair.second();

  Runner runner(byField);
  runner.run_();

  auto cast = static_cast<void (*)()>(byCast);
  cast();
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  g_pub = nh.advertise<std_msgs::Empty>("/out", 1);
  ros::Subscriber sub = nh.subscribe("/in", 1, onMessage);
  ros::spin();
}
