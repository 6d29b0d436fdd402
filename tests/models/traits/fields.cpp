// expect: field_begins Node::data_ .ready false
// expect: field_begins Node::data_ .value 0
#include <ros/ros.h>
#include <std_msgs/Empty.h>

struct Data {
  bool ready = false;
  double value = 0;
};

struct Built {
  Built() { ready = true; }
  bool ready = false;
};

void configure(Data& data) { data.ready = true; }

class Node {
public:
  Node() {
    configure(given_);
    Data& other = referred_;
    other.ready = true;
    Data* pointer = &pointed_;
    pointer->ready = true;
    set_.ready = true;
    out_ = nh_.advertise<std_msgs::Empty>("out", 1);
    go_ = nh_.subscribe("go", 1, &Node::onGo, this);
    in_ = nh_.subscribe("in", 1, &Node::onIn, this);
  }

private:
  void onGo(const std_msgs::Empty&) {
    data_.ready = true;
    set_.ready = false;
    built_.ready = false;
    given_.ready = referred_.ready = pointed_.ready = false;
  }

  void onIn(const std_msgs::Empty& message) {
    if (data_.ready && set_.ready && built_.ready) out_.publish(message);
    if (given_.ready && referred_.ready && pointed_.ready) out_.publish(message);
  }

  ros::NodeHandle nh_;
  ros::Publisher out_;
  ros::Subscriber go_, in_;
  Data data_, set_, given_, referred_, pointed_;
  Built built_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  Node node;
  ros::spin();
}
