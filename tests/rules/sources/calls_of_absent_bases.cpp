// Handles that an absent base class has: a call with a message makes a port as the handle's method of that name does, in a namespace that is not known.
//
// expect: publisher ?/answer std_msgs/Int32 queue=1
// expect: subscriber ?/number std_msgs/Int32 queue=1 callback=Display::onNumber
// expect: service_client ?/clear std_srvs/Empty
// expect-only: publisher subscriber service_client
// expect: open_at("ports", _, ["call", "subscribe"])
// expect-not: open_at("ports", _, ["call", "advertise"])
#include <absent_display/display.h>
#include <ros/ros.h>
#include <std_msgs/Int32.h>
#include <std_srvs/Empty.h>

class Display : public absent_display::Display
{
public:
  void onInitialize()
  {
    answer_ = update_nh_.advertise<std_msgs::Int32>("answer", 1);
    number_ = update_nh_.subscribe<std_msgs::Int32>("number", 1, &Display::onNumber, this);
    clear_ = handle().serviceClient<std_srvs::Empty>("clear");
    chosen_ = update_nh_.subscribe(topic(), 1, &Display::onNumber, this);
  }

private:
  void onNumber(const std_msgs::Int32::ConstPtr&) {}

  ros::Publisher answer_;
  ros::Subscriber number_, chosen_;
  ros::ServiceClient clear_;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "display");
  Display display;
  display.onInitialize();
  ros::spin();
}
