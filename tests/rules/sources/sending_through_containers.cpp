// Publishers that are kept in maps, lists, pairs and structures, handed to functions, or filled in by them: each message goes out where it belongs.
//
// expect: publisher /wheel/left std_msgs/Int32
// expect: publisher /wheel/right std_msgs/Int32
// expect: publisher /arm std_msgs/Int32
// expect: publisher /any std_msgs/Int32
// expect: publisher /listed std_msgs/Int32
// expect: publisher /paired std_msgs/Int32
// expect: publisher /connected std_msgs/Int32
// expect: publisher /bound std_msgs/Int32
// expect: publisher /shared std_msgs/Int32
// expect: publisher /spare std_msgs/Int32
// expect: publisher /chained std_msgs/Int32
// expect: publisher /found std_msgs/Int32
// expect: publisher /held std_msgs/Int32
// expect: publisher /returned std_msgs/Int32
// expect: subscriber /*
// expect: reactive /left -> /wheel/left may
// expect: reactive /left -> /any may
// expect: reactive /right -> /wheel/right may
// expect: reactive /right -> /any may
// expect: reactive /arm_in -> /arm must
// expect: reactive /list -> /listed must
// expect: reactive /pair -> /paired must
// expect: reactive /connect -> /connected must
// expect: reactive /bind -> /bound must
// expect: reactive /share -> /shared must
// expect: reactive /chain -> /chained must
// expect: reactive /find -> /found must
// expect: reactive /hold -> /held must
// expect: reactive /return -> /returned must
// expect-only: *
// expect: Count = count : { port_holder(V, Site), port([Site, _, "/spare"]) }, Count = 1
// expect: Count = count : { port_holder(V, Site), port([Site, _, "/listed"]) }, Count = 2
// expect: Count = count : { port_holder(V, Site), port([Site, _, "/connected"]) }, Count = 2
// expect: Count = count : { port_holder(V, Site), port([Site, _, "/shared"]) }, Count = 1
// expect: 17 = count : { port_holder(_, _) }, 1 = count : { sends_through(_, _) }
#include <map>
#include <memory>
#include <ros/ros.h>
#include <std_msgs/Int32.h>
#include <string>
#include <utility>
#include <vector>

typedef std::map<std::string, ros::Publisher> Publishers;

struct Arm
{
  ros::Publisher pub;
  int joints;
};

class Node
{
public:
  Node()
  {
    wheels_["left"] = nh_.advertise<std_msgs::Int32>("/wheel/left", 1);
    wheels_[std::string("right")] = nh_.advertise<std_msgs::Int32>("/wheel/right", 1);
    wheels_[std::to_string(wheels_.size())] = nh_.advertise<std_msgs::Int32>("/any", 1);
    arm_.pub = nh_.advertise<std_msgs::Int32>("/arm", 1);
    list_.push_back(nh_.advertise<std_msgs::Int32>("/listed", 1));
    pair_ = std::make_pair(nh_.advertise<std_msgs::Int32>("/paired", 1), 3);
    connect(connected_, "/connected");
    shared_ = std::make_shared<ros::Publisher>(nh_.advertise<std_msgs::Int32>("/shared", 1));
    spare_ = nh_.advertise<std_msgs::Int32>("/spare", 1);
    named_.emplace("found", nh_.advertise<std_msgs::Int32>("/found", 1));
    holder_.second = nh_.advertise<std_msgs::Int32>("/held", 1);
    bound_sub_ = nh_.subscribe<std_msgs::Int32>("/bind", 1, boost::bind(&Node::onBind, this, _1, nh_.advertise<std_msgs::Int32>("/bound", 1)));
    left_sub_ = nh_.subscribe("/left", 1, &Node::onLeft, this);
    right_sub_ = nh_.subscribe("/right", 1, &Node::onRight, this);
    arm_sub_ = nh_.subscribe("/arm_in", 1, &Node::onArm, this);
    list_sub_ = nh_.subscribe("/list", 1, &Node::onList, this);
    pair_sub_ = nh_.subscribe("/pair", 1, &Node::onPair, this);
    connect_sub_ = nh_.subscribe("/connect", 1, &Node::onConnect, this);
    share_sub_ = nh_.subscribe("/share", 1, &Node::onShare, this);
    chain_sub_ = nh_.subscribe("/chain", 1, &Node::onChain, this);
    find_sub_ = nh_.subscribe("/find", 1, &Node::onFind, this);
    hold_sub_ = nh_.subscribe("/hold", 1, &Node::onHold, this);
    return_sub_ = nh_.subscribe("/return", 1, &Node::onReturn, this);
    idle_sub_ = nh_.subscribe("/idle", 1, &Node::onIdle, this);
  }

private:
  void connect(ros::Publisher& pub, const std::string& name)
  {
    pub = nh_.advertise<std_msgs::Int32>(name, 1);
  }

  ros::Publisher make()
  {
    return nh_.advertise<std_msgs::Int32>("/returned", 1);
  }

  void onLeft(const std_msgs::Int32& message)
  {
    wheels_["left"].publish(message);
  }

  void onRight(const std_msgs::Int32& message)
  {
    ros::Publisher& right = wheels_[std::string("right")];
    right.publish(message);
  }

  void onArm(const std_msgs::Int32& message)
  {
    arm_.pub.publish(message);
  }

  void onList(const std_msgs::Int32& message)
  {
    for (const ros::Publisher& pub : list_)
      pub.publish(message);
  }

  void onPair(const std_msgs::Int32& message)
  {
    pair_.first.publish(message);
  }

  void onConnect(const std_msgs::Int32& message)
  {
    connected_.publish(message);
  }

  void onBind(const std_msgs::Int32ConstPtr& message, const ros::Publisher& pub)
  {
    pub.publish(*message);
  }

  void onShare(const std_msgs::Int32& message)
  {
    shared_->publish(message);
  }

  void onChain(const std_msgs::Int32& message)
  {
    (chained_ = nh_.advertise<std_msgs::Int32>("/chained", 1)).publish(message);
  }

  void onFind(const std_msgs::Int32& message)
  {
    named_.find("found")->second.publish(message);
  }

  void onHold(const std_msgs::Int32& message)
  {
    holder_.second.publish(message);
  }

  void onReturn(const std_msgs::Int32& message)
  {
    make().publish(message);
  }

  // asks, and sends nothing
  void onIdle(const std_msgs::Int32& message)
  {
    if (spare_.getNumSubscribers() > 0 && list_.size() > 1)
      ROS_INFO("%s is read", spare_.getTopic().c_str());
  }

  ros::NodeHandle nh_;
  Publishers wheels_, named_;
  Arm arm_;
  std::vector<ros::Publisher> list_;
  std::pair<ros::Publisher, int> pair_;
  std::pair<int, ros::Publisher> holder_;
  std::shared_ptr<ros::Publisher> shared_;
  ros::Publisher connected_, spare_, chained_;
  ros::Subscriber left_sub_, right_sub_, arm_sub_, list_sub_, pair_sub_, connect_sub_, share_sub_, chain_sub_, find_sub_, hold_sub_, return_sub_, idle_sub_;
  ros::Subscriber bound_sub_;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  Node node;
  ros::spin();
}
