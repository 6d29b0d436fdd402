// What messages hold that are made and sent by one function.
// expect: content_given(M, "data", S, V), content_sent(C, M), location(C, _, 22, _), location(S, _, 21, _), expr_text(V, "text")
// expect: content_begins(M, "data", I), content_sent(C, M), location(C, _, 22, _), location(I, _, 20, _)
// expect: content_kind(M, "data", _), content_sent(C, M), location(C, _, 22, _)
// expect-not: content_sent(C, _), location(C, _, 29, _)
// expect: content_sent(C, M), location(C, _, 35, _), content_given(M, "header.seq", _, _)
// expect-not: content_sent(C, M), location(C, _, 35, _), content_given(M, "header.frame_id", _, _)
// expect: 2 = count : { content_sent(C, M), location(C, _, L, _), L > 18 }
// expect: sends_constants([S, "publisher", "mode"])
// expect-not: sends_constants([S, "publisher", "other"])
#include <ros/ros.h>
#include <geometry_msgs/PointStamped.h>
#include <std_msgs/String.h>

ros::Publisher mode, other, point;

void change(std_msgs::String & message) { message.data = "changed"; }

void tell(const std::string & text) {
  std_msgs::String message;
  message.data = text;
  mode.publish(message);
}

void changed(const std::string & text) {
  std_msgs::String message;
  message.data = text;
  change(message);
  other.publish(message);
}

void mark(geometry_msgs::PointStamped in, int number) {
  geometry_msgs::PointStamped message;
  message.header.seq = number; message.header.frame_id = "map"; message.header.frame_id += "_2";
  point.publish(message);
}

void onText(const std_msgs::String & in) {
  if (in.data == "run") tell("run");
  else tell("stop");
  changed(in.data);
  mark(geometry_msgs::PointStamped(), 3);
}

int main(int argc, char ** argv) {
  ros::init(argc, argv, "teller");
  ros::NodeHandle nh;
  mode = nh.advertise<std_msgs::String>("mode", 1);
  other = nh.advertise<std_msgs::String>("other", 1);
  point = nh.advertise<geometry_msgs::PointStamped>("point", 1);
  ros::Subscriber sub = nh.subscribe("text", 1, onText);
  ros::spin();
}
