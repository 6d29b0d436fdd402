// A nodelet: the class that is registered is the component.
//
// expect: component Relay kind=nodelet
// expect: reactive in -> out must
#include <nodelet/nodelet.h>
#include <pluginlib/class_list_macros.h>
#include <ros/ros.h>
#include <std_msgs/String.h>

namespace relays
{
class Relay : public nodelet::Nodelet
{
  void onInit() override
  {
    pub_ = getNodeHandle().advertise<std_msgs::String>("out", 1);  // expect: publisher out
    sub_ = getNodeHandle().subscribe("in", 1, &Relay::onMessage, this);  // expect: subscriber in std_msgs/String
    // expect: finding subscriber-without-publisher "/Relay reads /Relay/again *"
    private_sub_ = getPrivateNodeHandle().subscribe("again", 1, &Relay::onMessage, this);  // expect: subscriber ~again
  }

  void onMessage(const std_msgs::StringConstPtr& message)
  {
    pub_.publish(message);
  }

  ros::Publisher pub_;
  ros::Subscriber sub_, private_sub_;
};
}  // namespace relays

PLUGINLIB_EXPORT_CLASS(relays::Relay, nodelet::Nodelet)
