// What one callback puts on the parameter server another one gets from there: its value, and that it was put there at all.
// expect: port_flow(In, Out, "data", "kept"), In = [_, "subscriber", "value"], Out = [_, "publisher", "read_out"]
// expect: port_flow(In, Out, "control", "kept"), In = [_, "subscriber", "go"], Out = [_, "publisher", "gone_out"]
// expect: port_flow(In, Out, "data", "kept"), In = [_, "subscriber", "value"], Out = [_, "publisher", "copied_out"]
// expect: port_flow(In, Out, "data", "kept"), In = [_, "subscriber", "kept"], Out = [_, "publisher", "later_out"]
#include <ros/ros.h>
#include <std_msgs/Float64.h>

class Node {
public:
  Node() {
    read_ = nh_.advertise<std_msgs::Float64>("read_out", 1);
    gone_ = nh_.advertise<std_msgs::Float64>("gone_out", 1);
    copied_ = nh_.advertise<std_msgs::Float64>("copied_out", 1);
    later_ = nh_.advertise<std_msgs::Float64>("later_out", 1);
    value_ = nh_.subscribe("value", 1, &Node::onValue, this);
    go_ = nh_.subscribe("go", 1, &Node::onGo, this);
    kept_ = nh_.subscribe("kept", 1, &Node::onKept, this);
    put_ = nh_.subscribe("put", 1, &Node::onPut, this);
    trigger_ = nh_.subscribe("trigger", 1, &Node::onTrigger, this);
    show_ = nh_.subscribe("show", 1, &Node::onShow, this);
  }

  void onValue(const std_msgs::Float64& m) { nh_.setParam("gain", m.data); }
  void onGo(const std_msgs::Float64&) { nh_.setParam("gone", 1.0); }
  void onKept(const std_msgs::Float64& m) { last_ = m.data; }
  void onPut(const std_msgs::Float64&) { nh_.setParam("last", last_); }

  void onTrigger(const std_msgs::Float64&) {
    double gain = 1, gone = 0, last = 0;
    nh_.getParam("gain", gain);
    nh_.getParam("gone", gone);
    nh_.getParam("last", last);
    std_msgs::Float64 out;
    out.data = gain;
    read_.publish(out);
    std_msgs::Float64 other;
    other.data = gone;
    gone_.publish(other);
    std_msgs::Float64 third;
    third.data = last;
    later_.publish(third);
    nh_.getParam("gain", copy_);
  }
  void onShow(const std_msgs::Float64&) {
    std_msgs::Float64 out;
    out.data = copy_;
    copied_.publish(out);
  }

  ros::NodeHandle nh_;
  ros::Publisher read_, gone_, copied_, later_;
  ros::Subscriber value_, go_, kept_, put_, trigger_, show_;
  double copy_ = 0, last_ = 0;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  Node node;
  ros::spin();
}
