// Two objects of one class: what one of them gets has nothing to do with what the other one sends, and a state variable that both have is told to be.
//
// expect: of_several_objects(V), variable_name(V, "open_")
// expect: 1 = count : { of_several_objects(_) }
// expect: port_flow([_, _, "left/in"], [_, _, "left/out"], _, _)
// expect: port_flow([_, _, "left/gate"], [_, _, "left/out"], _, _)
// expect: 0 = count : { port_flow([_, _, "left/in"], [_, _, "right/out"], _, _) }
// expect: 0 = count : { port_flow([_, _, "left/gate"], [_, _, "right/out"], _, _) }
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_msgs/Empty.h>
#include <string>

class Channel {
public:
  Channel(ros::NodeHandle& nh, const std::string& name) : open_(false) {
    out_ = nh.advertise<std_msgs::Empty>(name + "/out", 1);
    in_ = nh.subscribe(name + "/in", 1, &Channel::onIn, this);
    gate_ = nh.subscribe(name + "/gate", 1, &Channel::onGate, this);
  }

private:
  void onIn(const std_msgs::Empty& msg) {
    if (open_) out_.publish(msg);
  }
  void onGate(const std_msgs::Bool& msg) { open_ = msg.data; }

  bool open_;
  ros::Publisher out_;
  ros::Subscriber in_, gate_;
};

class Only {
public:
  explicit Only(ros::NodeHandle& nh) : set_(false) {
    out_ = nh.advertise<std_msgs::Empty>("only/out", 1);
    in_ = nh.subscribe("only/in", 1, &Only::onIn, this);
  }

private:
  void onIn(const std_msgs::Empty& msg) {
    if (set_) out_.publish(msg);
    set_ = true;
  }

  bool set_;
  ros::Publisher out_;
  ros::Subscriber in_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "two");
  ros::NodeHandle nh;
  Channel left(nh, "left");
  Channel right(nh, "right");
  Only only(nh);
  ros::spin();
}
