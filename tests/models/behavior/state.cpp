// State and transitions: members, statics, flags set by helpers, counters, parts, configuration, initial values, triggers.
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_msgs/Int32.h>

class Node
{
public:
  enum class Mode { IDLE, ACTIVE };
  Node() : pnh_("~"), mode_(Mode::IDLE)
  {
    pnh_.param("limit", limit_, 3);
    last_.data = 0;
    pub_ = nh_.advertise<std_msgs::Int32>("out", 1);
    enable_sub_ = nh_.subscribe("enable", 1, &Node::onEnable, this);
    data_sub_ = nh_.subscribe("data", 1, &Node::onData, this);
    timer_ = nh_.createTimer(ros::Duration(0.5), &Node::onTimer, this);
  }

private:
  void setMode(Mode mode) { mode_ = mode; }
  bool isActive() const { return mode_ == Mode::ACTIVE; }
  void onEnable(const std_msgs::Bool& m)
  {
    if (m.data)
      setMode(Mode::ACTIVE);
    unread_ = m.data;
  }
  void onData(const std_msgs::Int32& m)
  {
    static int seen = 0;
    if (!isActive())
      return;
    last_.data = m.data;
    if (++seen > limit_ && last_.data > 0)
    {
      pub_.publish(m);
      seen = 0;
    }
  }
  void onTimer(const ros::TimerEvent&)
  {
    if (mode_ == Mode::ACTIVE)
      setMode(Mode::IDLE);
  }

  ros::NodeHandle nh_, pnh_;
  ros::Publisher pub_;
  ros::Subscriber enable_sub_, data_sub_;
  ros::Timer timer_;
  Mode mode_;
  int limit_;
  bool unread_ = false;
  std_msgs::Int32 last_;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "n");
  Node node;
  ros::spin();
}
// expect: periodic timer 2.0 None  []
// expect: reactive data -> out may [!(!isActive()) && ++seen > limit_ && last_.data > 0]
// expect: state Node::last_ = 0
// expect: state Node::mode_ = Mode::IDLE
// expect: state Node::onData::seen = 0
// expect: config Node::limit_ = 3 ~limit
// expect: transition Node::last_ . data on data [!(!isActive())] := m.data
// expect: transition Node::mode_ . None on enable [m.data] := Mode::ACTIVE
// expect: transition Node::mode_ . None on periodic [mode_ == Mode::ACTIVE] := Mode::IDLE
// expect: transition Node::onData::seen . None on data [!(!isActive())] := ++seen
// expect: transition Node::onData::seen . None on data [!(!isActive()) && ++seen > limit_ && last_.data > 0] := 0
