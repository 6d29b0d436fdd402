// With parameters at their defaults a condition on them chooses: what it leads past gives no names.
//
// expect: Count = count : { default_truth(E, "true"), operator(E, _) }, Count = 8
// expect: Count = count : { default_truth(E, "false"), operator(E, _) }, Count = 6
// expect: default_truth(E, "true"), expr_text(E, "empty.empty()")
// expect: default_truth(E, "false"), expr_text(E, "text.empty()")
// expect: subscriber /chosen
// expect-not: subscriber /not_chosen
// expect-not: default_text(V, _), variable_name(V, "changed")
// expect-not: default_text(V, _), variable_name(V, "passed")
// expect: default_text(V, "3"), variable_name(V, "mode")
// expect: default_text(V, "false"), variable_name(V, "fake_")
// expect: 27 = count : { defined_text(_, _, _, _, _) }
// expect-not: seen_otherwise(_, _, _)
#include <ros/ros.h>
#include <std_msgs/Empty.h>

void onMessage(const std_msgs::Empty&)
{
}

void change(int& number)
{
  number = 4;
}

class Node
{
public:
  Node() : private_nh_("~"), fake_(private_nh_.param("fake", false))
  {
    int mode, changed, passed;
    bool on;
    std::string text, empty;
    private_nh_.param("mode", mode, 3);
    private_nh_.param("on", on, true);
    private_nh_.param<std::string>("text", text, "text");
    private_nh_.param<std::string>("empty", empty, "");
    private_nh_.param("changed", changed, 1);
    private_nh_.param("passed", passed, 1);
    changed += 2;
    change(passed);

    if (mode == 3)
      name_ = "/chosen";
    if (mode == 4)
      name_ = "/not_chosen";
    if (mode != 3)
      name_ = "/not_chosen";
    if (mode != 4)
      name_ = "/chosen";
    if (on == true)
      name_ = "/chosen";
    if (on != true)
      name_ = "/not_chosen";
    if (text != "text")
      name_ = "/not_chosen";
    if (text.empty())
      name_ = "/not_chosen";
    if (empty.empty())
      name_ = "/chosen";
    if (!on)
      name_ = "/not_chosen";
    if (!fake_)
      name_ = "/chosen";
    if (fake_)
      name_ = "/not_chosen";
    if (on && mode == 3)
      name_ = "/chosen";
    if (fake_ && mode == 3)
      name_ = "/not_chosen";
    if (fake_ || on)
      name_ = "/chosen";
    sub_ = nh_.subscribe(name_, 1, onMessage);
  }

private:
  ros::NodeHandle nh_, private_nh_;
  bool fake_;
  std::string name_;
  ros::Subscriber sub_;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  Node node;
  ros::spin();
}
