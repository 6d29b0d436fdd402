// Functions kept and called elsewhere: in members of another class, in containers, bound to arguments, and run once by a timer.
#include <map>
#include <vector>
#include <string>
#include <boost/bind.hpp>
#include <boost/function.hpp>
#include <boost/thread.hpp>
#include <functional>
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_msgs/Int32.h>

class Port
{
public:
  typedef boost::function<void(int)> Handler;
  void onData(Handler handler) { handler_ = handler; }
  void start() { thread_ = new boost::thread(boost::bind(&Port::run, this, 4.0)); }

private:
  void run(double hz)
  {
    ros::Rate rate(hz);
    while (ros::ok())
    {
      if (handler_)
        handler_(read());
      rate.sleep();
    }
  }
  int read();
  Handler handler_;
  boost::thread* thread_;
};

class Node
{
public:
  Node(ros::NodeHandle& nh)
  {
    data_ = nh.advertise<std_msgs::Int32>("data", 1);
    alarm_ = nh.advertise<std_msgs::Bool>("alarm", 1);
    done_ = nh.advertise<std_msgs::Bool>("done", 1);
    lost_ = nh.advertise<std_msgs::Bool>("lost", 1);
    port_.onData(boost::bind(&Node::onData, this, _1));
    commands_[1] = &Node::stop;
    commands_[2] = [](Node* node) { node->finish(); };
    listeners_.push_back([this](const std_msgs::Int32& m) { announce(m); });
    unused_.push_back([this](const std_msgs::Int32&) { lost_.publish(std_msgs::Bool()); });
    command_sub_ = nh.subscribe("command", 1, &Node::onCommand, this);
    value_sub_ = nh.subscribe<std_msgs::Int32>("value", 1, boost::bind(&Node::onValue, this, _1, 7));
    once_ = nh.createTimer(ros::Duration(3.0), &Node::onLate, this, true);
    port_.start();
  }

private:
  void onData(int value)
  {
    if (stopped_)
      return;
    std_msgs::Int32 m;
    m.data = value;
    data_.publish(m);
  }
  void onCommand(const std_msgs::Int32& m)
  {
    if (commands_.find(m.data) != commands_.end())
      commands_[m.data](this);
  }
  void onValue(const std_msgs::Int32::ConstPtr& m, int limit)
  {
    if (m->data > limit)
      for (auto& listener : listeners_)
        listener(*m);
  }
  void onLate(const ros::TimerEvent&) { stopped_ = true; }
  void stop() { stopped_ = true; }
  void finish() { done_.publish(std_msgs::Bool()); }
  void announce(const std_msgs::Int32&) { alarm_.publish(std_msgs::Bool()); }

  Port port_;
  ros::Publisher data_, alarm_, done_, lost_;
  ros::Subscriber command_sub_, value_sub_;
  ros::Timer once_;
  std::map<int, std::function<void(Node*)>> commands_;
  std::vector<std::function<void(const std_msgs::Int32&)>> listeners_, unused_;
  bool stopped_ = false;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "n");
  ros::NodeHandle nh;
  Node node(nh);
  ros::spin();
}
// expect: periodic rate 4.0 None data [handler_ && !stopped_]
// expect: reactive command -> done may [commands_.find(m.data) != commands_.end() && m.data == 2]
// expect: reactive value -> alarm may [m->data > limit]
// expect: state Node::stopped_ = false
// expect: config Port::handler_ = handler None
// expect: config Node::commands_ = None None
// expect: config Node::listeners_ = None None
// expect: transition Node::stopped_ . None on command [commands_.find(m.data) != commands_.end() && m.data == 1] := true
// expect: transition Node::stopped_ . None on timer [] := true
