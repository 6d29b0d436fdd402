// Names and lengths of queues that are reconfigurable parameters: of servers below the node, in its namespace, and in another.
//
// expect: N = count : { reconfigure_parameter(_, _, _, _) }, N = 6
// expect: N = count : { configured(_, _, _, _) }, N = 7
// expect: reconfigure_parameter(_, "~topic", "string", "/own")
// expect: reconfigure_parameter(_, "~queue", "int", "2")
// expect: reconfigure_parameter(_, "topic", "string", "/global")
// expect: reconfigure_parameter(_, "named/topic", "string", "/named")
// expect: reconfigure_parameter(_, "named/queue", "int", "4")
// expect: 3 = count : { parameter_clamped(_, _, _, _) }
// expect: parameter_clamped(_, "named/queue", "1", "10")
// expect: 5 = count : { name_parameter(_, _, _, _) }
#include <dynamic_reconfigure/server.h>
#include <parameters_reconfigured/GlobalConfig.h>
#include <parameters_reconfigured/NamedConfig.h>
#include <parameters_reconfigured/OwnConfig.h>
#include <parameters_reconfigured/UnusedConfig.h>
#include <ros/ros.h>
#include <std_msgs/Empty.h>

using namespace parameters_reconfigured;

void onMessage(const std_msgs::Empty&)
{
}

class Node
{
public:
  Node() : named_nh_("named"), global_(nh_), named_(named_nh_)
  {
    own_.setCallback(boost::bind(&Node::onOwn, this, _1, _2));
    global_.setCallback(boost::bind(&Node::onGlobal, this, _1, _2));
    named_.setCallback(boost::bind(&Node::onNamed, this, _1, _2));
  }

private:
  void onOwn(OwnConfig& config, uint32_t level)
  {
    subs_[0] = nh_.subscribe(config.topic, config.queue, onMessage);  // expect: subscriber /own from_param=~topic queue=2
  }
  void onGlobal(GlobalConfig& config, uint32_t level)
  {
    subs_[1] = nh_.subscribe(config.topic, config.queue, onMessage);  // expect: subscriber /global from_param=topic queue=3
    config.queue = last_.queue;
  }
  void onNamed(NamedConfig& config, uint32_t level)
  {
    subs_[2] = nh_.subscribe(config.topic, config.queue, onMessage);  // expect: subscriber /named from_param=named/topic queue=4
  }
  void onUnused(UnusedConfig& config)
  {
    subs_[3] = nh_.subscribe(config.topic, config.queue, onMessage);
  }

  ros::NodeHandle nh_, named_nh_;
  dynamic_reconfigure::Server<OwnConfig> own_;
  dynamic_reconfigure::Server<GlobalConfig> global_;
  dynamic_reconfigure::Server<NamedConfig> named_;
  GlobalConfig last_;
  ros::Subscriber subs_[4];
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  Node node;
  ros::spin();
}
