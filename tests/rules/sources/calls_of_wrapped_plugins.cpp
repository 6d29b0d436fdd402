// A plug-in that a template makes of a class: the object that it holds is of that class, and made with what that takes.
//
// expect: publisher stop/report
// expect: publisher ~debug/stop
// expect-only: publisher
#include <memory>
#include <nodelet/nodelet.h>
#include <pluginlib/class_list_macros.h>
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <string>

class Manager
{
public:
  Manager(ros::NodeHandle & node, const char * name)
  {
    debug_ = node.advertise<std_msgs::Empty>(std::string("~debug/") + name, 1);
  }
  virtual ~Manager() = default;
  virtual const char * name() = 0;

private:
  ros::Publisher debug_;
};

class StopManager : public Manager
{
public:
  explicit StopManager(ros::NodeHandle & node) : Manager(node, name())
  {
    report_ = node.advertise<std_msgs::Empty>(std::string(name()) + "/report", 1);
  }
  const char * name() override { return "stop"; }

private:
  ros::Publisher report_;
};

// of which no plug-in is made
class GoManager : public Manager
{
public:
  explicit GoManager(ros::NodeHandle & node) : Manager(node, name()) {}
  const char * name() override { return "go"; }
};

template <class T>
class Wrapper : public nodelet::Nodelet
{
  void onInit() override { manager_ = std::make_unique<T>(getNodeHandle()); }

  std::unique_ptr<T> manager_;
};

class Stop : public Wrapper<StopManager>
{
};

PLUGINLIB_EXPORT_CLASS(Stop, nodelet::Nodelet)
