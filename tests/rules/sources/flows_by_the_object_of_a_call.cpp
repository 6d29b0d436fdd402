// Which of several functions a call enters hangs on its object: a callback that replaces it decides what another one sends, itself or through what it calls.
// expect: port_flow(In, Out, "control", "kept"), In = [_, "subscriber", "in"], Out = [_, "publisher", "swapped_out"]
// expect: kept_from(V, In, "control"), variable_name(V, "mode_"), In = [_, "subscriber", "in"]
// expect-not: port_flow(In, Out, _, _), In = [_, "subscriber", "in"], Out = [_, "publisher", "plain_out"]
#include <memory>
#include <ros/ros.h>
#include <std_msgs/Float64.h>

struct Handler {
  virtual ~Handler() {}
  virtual void run(ros::Publisher& pub, int& mode) = 0;
};

struct On : Handler {
  void run(ros::Publisher& pub, int& mode) override { send(pub); }
  void send(ros::Publisher& pub) { pub.publish(std_msgs::Float64()); }
};

int mode_ = 0;
struct Off : Handler {
  void run(ros::Publisher&, int&) override { mode_ = 1; }
};

struct Plain {
  void run(ros::Publisher& pub) { pub.publish(std_msgs::Float64()); }
};

class Node {
public:
  Node() {
    pub_ = nh_.advertise<std_msgs::Float64>("swapped_out", 1);
    plain_ = nh_.advertise<std_msgs::Float64>("plain_out", 1);
    in_ = nh_.subscribe("in", 1, &Node::onIn, this);
    trigger_ = nh_.subscribe("trigger", 1, &Node::onTrigger, this);
    handler_.reset(new Off());
  }
  void onIn(const std_msgs::Float64&) { handler_.reset(new On()); }
  void onTrigger(const std_msgs::Float64&) {
    int mode = 0;
    handler_->run(pub_, mode);
    always_.run(plain_);
  }

  ros::NodeHandle nh_;
  ros::Publisher pub_, plain_;
  ros::Subscriber in_, trigger_;
  std::unique_ptr<Handler> handler_;
  Plain always_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  Node node;
  ros::spin();
}
