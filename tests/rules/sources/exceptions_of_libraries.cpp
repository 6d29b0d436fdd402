// What libraries throw for what they are given keeps a callback from sending, unless it is caught or asked for before.
//
// expect: always_reacts([_, _, "caught"], [_, _, "of_caught"])
// expect: always_reacts([_, _, "asked"], [_, _, "of_asked"])
// expect: perhaps_always([_, _, "text"], [_, _, "of_text"])
// expect: perhaps_always([_, _, "key"], [_, _, "of_key"])
// expect: 2 = count : { always_reacts(_, _) }
#include <map>
#include <string>
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <std_msgs/String.h>

ros::Publisher of_caught, of_asked, of_text, of_key;
std::map<std::string, int> known;

void caught(const std_msgs::String& message)
{
  try {
    int value = std::stoi(message.data);
  } catch (const std::exception&) {
  }
  of_caught.publish(std_msgs::Empty());
}
void asked(const std_msgs::String& message)
{
  if (known.count(message.data)) known.at(message.data) = 1;
  of_asked.publish(std_msgs::Empty());
}
void text(const std_msgs::String& message)
{
  int value = std::stoi(message.data);
  of_text.publish(std_msgs::Empty());
}
void key(const std_msgs::String& message)
{
  known.at(message.data) = 1;
  of_key.publish(std_msgs::Empty());
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  of_caught = nh.advertise<std_msgs::Empty>("of_caught", 1);
  of_asked = nh.advertise<std_msgs::Empty>("of_asked", 1);
  of_text = nh.advertise<std_msgs::Empty>("of_text", 1);
  of_key = nh.advertise<std_msgs::Empty>("of_key", 1);
  ros::Subscriber a = nh.subscribe("caught", 1, caught);
  ros::Subscriber b = nh.subscribe("asked", 1, asked);
  ros::Subscriber c = nh.subscribe("text", 1, text);
  ros::Subscriber d = nh.subscribe("key", 1, key);
  ros::spin();
}
