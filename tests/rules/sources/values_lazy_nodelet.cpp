// The handles of a lazy nodelet are those of its base class.
//
// expect: publisher out std_msgs/Empty
// expect: publisher ~status std_msgs/Empty
// expect-only: publisher
#include <nodelet_topic_tools/nodelet_lazy.h>
#include <pluginlib/class_list_macros.h>
#include <ros/ros.h>
#include <std_msgs/Empty.h>

class Lazy : public nodelet_topic_tools::NodeletLazy
{
public:
  virtual void onInit()
  {
    nodelet_topic_tools::NodeletLazy::onInit();
    pub_ = nh_->advertise<std_msgs::Empty>("out", 1);
    status_ = pnh_->advertise<std_msgs::Empty>("status", 1);
  }
  virtual void subscribe()
  {
  }
  virtual void unsubscribe()
  {
  }

private:
  ros::Publisher pub_, status_;
};
PLUGINLIB_EXPORT_CLASS(Lazy, nodelet::Nodelet)
