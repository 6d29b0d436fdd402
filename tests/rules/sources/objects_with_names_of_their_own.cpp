// What objects keep of how they were made: the name and the message of each go together.
//
// expect: subscriber /level std_msgs/Int32
// expect: subscriber /text std_msgs/String
// expect: subscriber /open std_msgs/Bool
// expect: subscriber /either
// expect-only: subscriber
// expect: N = count : { call_about(_, _) }, N = 10
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_msgs/Int32.h>
#include <std_msgs/String.h>
#include <string>

template <typename MESSAGE>
class Last {
public:
  explicit Last(const std::string& topic) : topic_{topic} {}
  void start(ros::NodeHandle* nh) { sub_ = nh->subscribe(topic_, 10, &Last::keep, this); }
  void keep(const MESSAGE& message) { message_ = message; }

private:
  std::string topic_;
  MESSAGE message_{};
  ros::Subscriber sub_;
};

// which instance is started is not told
template <typename MESSAGE>
class Either {
public:
  void start() { sub_ = nh_.subscribe("/either", 1, &Either::keep, this); }
  void keep(const MESSAGE&) {}

private:
  ros::NodeHandle nh_;
  ros::Subscriber sub_;
};

Last<std_msgs::Int32> g_level{"/level"};
Last<std_msgs::String> g_text{"/text"};
Last<std_msgs::Bool> g_open{"/open"};
Either<std_msgs::Int32> g_either;
Either<std_msgs::String> g_or;

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  g_level.start(&nh);
  g_text.start(&nh);
  g_open.start(&nh);
  if (argc > 1) {
    g_either.start();
  } else {
    g_or.start();
  }
  ros::spin();
}
