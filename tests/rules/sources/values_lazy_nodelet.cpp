// The handles of a lazy nodelet are those of its base class.
//
// expect: publisher out std_msgs/Empty
// expect: publisher ~status std_msgs/Empty
// expect-only: publisher
// expect: Places = count : { _place_in(_, _) }, Classes = count : { call_class(_, _) }, Places = 6, Classes = 6
// expect-not: _constructed(_, _); _inherits_constructors(_); chained_role(_, _, _); _at_defaults(_); _types(_, _); _takes_values(_); _pair(_, _, _); _inside(_, _); _place_of(_, _)
// expect-not: managed_publisher(_)
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
