// Objects that containers make in place, and objects that templates make from arguments whose type is not known yet.
//
// expect: subscriber plain std_msgs/Bool callback=Handle::onFlag
// expect: subscriber second std_msgs/Float64 callback=Number::onNumber
// expect: subscriber filtered std_msgs/Int32
// expect: subscriber kept std_msgs/Bool callback=Handle::onFlag
// expect: subscriber lift/*
// expect-only: subscriber
// expect: action_server lift control_msgs/GripperCommandAction callback=Lift::onGoal
#include <actionlib/server/action_server.h>
#include <control_msgs/GripperCommandAction.h>
#include <list>
#include <message_filters/subscriber.h>
#include <optional>
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_msgs/Float64.h>
#include <std_msgs/Int32.h>
#include <string>
#include <vector>

struct Handle
{
  Handle(const std::string& name, ros::NodeHandle& nh)
  {
    sub_ = nh.subscribe(name, 1, &Handle::onFlag, this);
  }
  explicit Handle(ros::NodeHandle& nh)
  {
    sub_ = nh.subscribe("never", 1, &Handle::onFlag, this);
  }
  void onFlag(const std_msgs::BoolConstPtr&) {}

  ros::Subscriber sub_;
};

struct Number
{
  Number(const std::string& name, ros::NodeHandle& nh)
  {
    sub_ = nh.subscribe(name, 1, &Number::onNumber, this);
  }
  void onNumber(const std_msgs::Float64ConstPtr&) {}

  ros::Subscriber sub_;
};

class Mux
{
public:
  void init()
  {
    make("second", *numbers_);
  }

private:
  template <class T>
  void make(const std::string& name, std::list<T>& made)
  {
    made.emplace_back(name, nh_);
  }

  ros::NodeHandle nh_;
  std::shared_ptr<std::list<Number>> numbers_ = std::make_shared<std::list<Number>>();
};

template <class Hardware>
class Lift
{
public:
  typedef actionlib::ActionServer<control_msgs::GripperCommandAction> Server;

  explicit Lift(ros::NodeHandle& nh)
  {
    server_.reset(new Server(nh, "lift", boost::bind(&Lift::onGoal, this, _1), boost::bind(&Lift::onCancel, this, _1), false));
  }

private:
  void onGoal(Server::GoalHandle) {}
  void onCancel(Server::GoalHandle) {}

  std::shared_ptr<Server> server_;
  Hardware hardware_;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "elements");
  ros::NodeHandle nh;
  std::vector<Handle> handles;
  handles.emplace_back("plain", nh);
  handles.emplace_back(handles.front());
  std::optional<Handle> kept;
  kept.emplace("kept", nh);
  std::vector<message_filters::Subscriber<std_msgs::Int32>> filters;
  filters.emplace_back(nh, "filtered", 1);
  Mux mux;
  mux.init();
  Lift<int> lift(nh);
  ros::spin();
}
