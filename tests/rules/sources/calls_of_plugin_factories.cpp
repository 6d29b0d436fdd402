// A plug-in that is an instance of a template: it makes objects of its own argument, not of those of other instances.
//
// expect: publisher ~stop
// expect-only: publisher
#include <memory>
#include <nodelet/nodelet.h>
#include <pluginlib/class_list_macros.h>
#include <ros/ros.h>
#include <std_msgs/Empty.h>

class StopManager
{
public:
  explicit StopManager(ros::NodeHandle & node) { stop_ = node.advertise<std_msgs::Empty>("stop", 1); }

private:
  ros::Publisher stop_;
};

class GoManager
{
public:
  explicit GoManager(ros::NodeHandle & node) { go_ = node.advertise<std_msgs::Empty>("go", 1); }

private:
  ros::Publisher go_;
};

template <class T>
class Factory : public nodelet::Nodelet
{
  void onInit() override { manager_ = std::make_shared<T>(getPrivateNodeHandle()); }

  std::shared_ptr<T> manager_;
};

// of which no plug-in is made
static Factory<GoManager> * other = nullptr;

PLUGINLIB_EXPORT_CLASS(Factory<StopManager>, nodelet::Nodelet)
