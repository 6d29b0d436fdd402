// Arguments that are given to a function beforehand, by a binder or with a thread.
//
// expect: publisher /left/value
// expect: publisher /right/value
// expect: publisher /free/value
// expect: publisher /lambda/value
// expect: publisher /thread/value
// expect: publisher /worker/value
// expect: publisher /kept/value
// expect: publisher /second/first
// expect-only: publisher
// expect: Count = count : { bound_argument(F, I, A), literal(A, "string", _) }, Count = 10
// expect: N = count : { _passed_to(_, _) }, N = 1
// expect-not: value_source(_, _)
#include <boost/bind.hpp>
#include <functional>
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <string>
#include <thread>
#include <vector>

std::vector<ros::Publisher> g_pubs;

void open(const std::string& name)
{
  g_pubs.push_back(ros::NodeHandle().advertise<std_msgs::Empty>(name + "/value", 1));
}

class Node
{
public:
  explicit Node(ros::NodeHandle& nh)
  {
    left_ = nh.subscribe<std_msgs::Empty>("/in", 1, boost::bind(&Node::onIn, this, _1, "/left"));
    right_ = nh.subscribe<std_msgs::Empty>("/in", 1, std::bind(&Node::onIn, this, std::placeholders::_1, "/right"));
    kept_ = boost::bind(&Node::run, this, "/kept");
    kept_();
    thread_ = std::thread(&Node::run, this, "/worker");
  }

private:
  void onIn(const std_msgs::EmptyConstPtr&, const std::string& name)
  {
    open(name);
  }

  void run(const std::string& name)
  {
    open(name);
  }

  ros::Subscriber left_, right_;
  std::function<void()> kept_;
  std::thread thread_;
};

void onFree(const std_msgs::EmptyConstPtr&, const std::string& name)
{
  open(name);
}

void work(const std::string& name)
{
  open(name);
}

// the second is bound, then the first is given
void two(const std::string& first, const std::string& second)
{
  g_pubs.push_back(ros::NodeHandle().advertise<std_msgs::Empty>(second + "/" + first, 1));
}

// bound, and never called by anybody known: what it is given is no name of others
void other(const std::string& name) {}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  Node node(nh);
  ros::Subscriber free_sub = nh.subscribe<std_msgs::Empty>("/in", 1, boost::bind(onFree, _1, "/free"));
  auto lambda = [](const std::string& name) { open(name); };
  std::function<void()> bound = std::bind(lambda, "/lambda");
  bound();
  std::thread thread(work, "/thread");
  std::function<void()> both = std::bind(two, "first", "/second");
  both();
  std::function<void()> unused = std::bind(other, "/never");
  ros::spin();
}
