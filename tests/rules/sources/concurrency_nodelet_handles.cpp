// A nodelet's handles whose callbacks run in any thread, kept and copied.
//
// expect: concurrent_callbacks(F, G), function_name(F, "threads::Node::onAssigned"), function_name(G, "threads::Node::onPlain")
// expect: concurrent_callbacks(F, G), function_name(F, "threads::Node::onCopied"), function_name(G, "threads::Node::onPlain")
// expect: concurrent_callbacks(F, G), function_name(F, "threads::Node::onPlain"), function_name(G, "threads::Node::onAssigned")
// expect: Count = count : { concurrent_callbacks(F, G) }, Count = 18
// expect-not: concurrent_callbacks(F, G), function_name(F, "threads::Node::onPlain"), function_name(G, "threads::Node::onPlainToo")
#include <nodelet/nodelet.h>
#include <pluginlib/class_list_macros.h>
#include <ros/ros.h>
#include <std_msgs/Empty.h>

namespace threads
{
class Node : public nodelet::Nodelet
{
  void onInit() override
  {
    nh_ = getMTNodeHandle();
    ros::NodeHandle copied(getMTPrivateNodeHandle());
    ros::NodeHandle* pointer = &getMTNodeHandle();
    plain_ = getNodeHandle();
    subs_[4] = pointer->subscribe("pointed", 1, &Node::onPointed, this);
    subs_[5] = plain_.subscribe("kept", 1, &Node::onKept, this);
    plain_.getParam("rate", rate_);
    subs_[0] = nh_.subscribe("assigned", 1, &Node::onAssigned, this);
    subs_[1] = copied.subscribe("copied", 1, &Node::onCopied, this);
    subs_[2] = getNodeHandle().subscribe("plain", 1, &Node::onPlain, this);
    subs_[3] = getNodeHandle().subscribe("plain_too", 1, &Node::onPlainToo, this);
  }

  void onAssigned(const std_msgs::Empty&)
  {
  }

  void onCopied(const std_msgs::Empty&)
  {
  }

  void onPlain(const std_msgs::Empty&)
  {
  }

  void onPointed(const std_msgs::Empty&)
  {
  }

  void onKept(const std_msgs::Empty&)
  {
  }

  void onPlainToo(const std_msgs::Empty&)
  {
  }

  ros::NodeHandle nh_, plain_;
  ros::Subscriber subs_[6];
  double rate_;
};
}  // namespace threads

PLUGINLIB_EXPORT_CLASS(threads::Node, nodelet::Nodelet)
