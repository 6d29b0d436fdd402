#include "tool.h"

#include <nodelet/nodelet.h>
#include <pluginlib/class_list_macros.h>
#include <std_msgs/Float64.h>
#include <std_msgs/UInt32.h>

namespace workbench
{
class Drill : public Tool
{
public:
  void initialize(ros::NodeHandle& nh) override
  {
    speed_ = nh.subscribe("drill/speed", 1, &Drill::onSpeed, this);
  }

private:
  void onSpeed(const std_msgs::Float64&)
  {
  }

  ros::Subscriber speed_;
};

class Counter : public nodelet::Nodelet
{
  void onInit() override
  {
    count_ = getMTPrivateNodeHandle().advertise<std_msgs::UInt32>("count", 1);
    parts_ = getMTNodeHandle().subscribe("parts", 10, &Counter::onPart, this);
    reset_ = getNodeHandle().subscribe("reset", 1, &Counter::onReset, this);
  }

  void onPart(const std_msgs::Float64&)
  {
    ++total_.data;
    count_.publish(total_);
  }

  void onReset(const std_msgs::UInt32ConstPtr&)
  {
    total_.data = 0;
  }

  ros::Publisher count_;
  ros::Subscriber parts_, reset_;
  std_msgs::UInt32 total_;
};
}  // namespace workbench

PLUGINLIB_EXPORT_CLASS(workbench::Drill, workbench::Tool)
PLUGINLIB_EXPORT_CLASS(workbench::Counter, nodelet::Nodelet)
