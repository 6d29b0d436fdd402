#include <ros/ros.h>
#include <topic_tools/shape_shifter.h>

namespace
{
ros::NodeHandle* node = nullptr;
ros::Publisher output;
bool advertised = false;

void onMessage(const topic_tools::ShapeShifter::ConstPtr& message)
{
  if (!advertised)
  {
    output = message->advertise(*node, "output", 10, true);
    advertised = true;
  }
  output.publish(message);
}

void onEvent(const ros::MessageEvent<topic_tools::ShapeShifter const>& event)
{
  ROS_INFO("%s", event.getPublisherName().c_str());
}
}  // namespace

int main(int argc, char** argv)
{
  ros::init(argc, argv, "relay");
  ros::NodeHandle nh;
  node = &nh;
  ros::Subscriber input = nh.subscribe<topic_tools::ShapeShifter>("input", 10, &onMessage, ros::TransportHints().tcpNoDelay());
  ros::Subscriber watched = nh.subscribe("watched", 5, onEvent);
  ros::spin();
  return 0;
}
