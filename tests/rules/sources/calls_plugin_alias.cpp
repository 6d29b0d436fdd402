// A plug-in that is registered under another name of its class: the library makes it, and calls what it overrides.
//
// expect: publisher opened
// expect: publisher inherited
// expect: publisher ticked
// expect-only: publisher
// expect: Count = count : { plugin_class(Class) }, Count = 1
// expect: plugin_class("tools::Worker")
#include <nodelet/nodelet.h>
#include <pluginlib/class_list_macros.h>
#include <ros/ros.h>
#include <std_msgs/Empty.h>

namespace tools
{
class Base : public nodelet::Nodelet
{
public:
  virtual void tick()
  {
    inherited_ = getNodeHandle().advertise<std_msgs::Empty>("inherited", 1);
  }

private:
  ros::Publisher inherited_;
};

class Worker : public Base
{
  void onInit() override
  {
    pub_ = getNodeHandle().advertise<std_msgs::Empty>("opened", 1);
    tick();
    Base::tick();
  }

  void tick() override
  {
    ticked_ = getNodeHandle().advertise<std_msgs::Empty>("ticked", 1);
  }

  // nobody calls it
  void help()
  {
    pub_ = getNodeHandle().advertise<std_msgs::Empty>("never", 1);
  }

  ros::Publisher pub_, ticked_;
};
}  // namespace tools

typedef tools::Worker WorkerNodelet;
PLUGINLIB_EXPORT_CLASS(WorkerNodelet, nodelet::Nodelet)
