#include <ros/ros.h>
#include "absent.h"
namespace here { template <class T> struct Box { T value; T get() const { return value; } };
enum class State { A, B };
class Node : public absent::Base { public:
  Node() : state_(State::A), rate_(10) { sub_ = nh_.subscribe("in", 1, &Node::on, this); timer_ = nh_.createTimer(ros::Duration(0.1), [this](const ros::TimerEvent&) { pub_.publish(msg_); }); }
  void on(const absent::Msg::ConstPtr& m) { if (!m->ok || rate_ > 3) return; switch (state_) { case State::A: state_ = State::B; break; default: for (auto& x : m->list) { try { use(x); } catch (...) { continue; } } } }
private: ros::NodeHandle nh_{"~"}; ros::Subscriber sub_; ros::Publisher pub_; ros::Timer timer_; State state_; int rate_; Box<int> msg_; }; }
int main(int argc, char** argv) { ros::init(argc, argv, "n"); here::Node n; do { ros::spinOnce(); } while (ros::ok() && argc ? true : false); goto end; end: return 0; }
