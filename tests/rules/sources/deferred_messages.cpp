// What arrives is kept, and a timer or a timed loop sends something made of it: through locals, structures, helpers and references.
//
// expect: deferred /direct -> /out variable=direct_
// expect: deferred /local -> /out variable=local_
// expect: deferred /field -> /out variable=field_
// expect: deferred /element -> /out variable=element_
// expect: deferred /pushed -> /out variable=pushed_
// expect: deferred /filled -> /out variable=filled_
// expect: deferred /made -> /out variable=made_
// expect: deferred /getter -> /out variable=getter_
// expect: deferred /passed -> /helped variable=passed_
// expect: deferred /twice -> /helped variable=twice_
// expect: deferred /pointed -> /out variable=pointed_
// expect: deferred /loop -> /looped variable=loop_
// expect: deferred /nested -> /looped variable=nested_
// expect-only: deferred
// expect: Count = count : { message_argument(P, C, A) }, Count = 6
// expect: 22 = count : { depends_on(_, _) }
#include <ros/ros.h>
#include <std_msgs/Float64MultiArray.h>
#include <std_msgs/Int32.h>
#include <vector>

class Node
{
public:
  Node()
  {
    out_ = nh_.advertise<std_msgs::Float64MultiArray>("/out", 1);
    helped_ = nh_.advertise<std_msgs::Int32>("/helped", 1);
    looped_ = nh_.advertise<std_msgs::Int32>("/looped", 1);
    other_ = nh_.advertise<std_msgs::Int32>("/other", 1);
    subs_.push_back(nh_.subscribe("/direct", 1, &Node::onDirect, this));
    subs_.push_back(nh_.subscribe("/local", 1, &Node::onLocal, this));
    subs_.push_back(nh_.subscribe("/field", 1, &Node::onField, this));
    subs_.push_back(nh_.subscribe("/element", 1, &Node::onElement, this));
    subs_.push_back(nh_.subscribe("/pushed", 1, &Node::onPushed, this));
    subs_.push_back(nh_.subscribe("/filled", 1, &Node::onFilled, this));
    subs_.push_back(nh_.subscribe("/made", 1, &Node::onMade, this));
    subs_.push_back(nh_.subscribe("/getter", 1, &Node::onGetter, this));
    subs_.push_back(nh_.subscribe("/passed", 1, &Node::onPassed, this));
    subs_.push_back(nh_.subscribe("/twice", 1, &Node::onTwice, this));
    subs_.push_back(nh_.subscribe("/pointed", 1, &Node::onPointed, this));
    subs_.push_back(nh_.subscribe("/compared", 1, &Node::onCompared, this));
    subs_.push_back(nh_.subscribe("/unsent", 1, &Node::onUnsent, this));
    subs_.push_back(nh_.subscribe("/asked", 1, &Node::onAsked, this));
    subs_.push_back(nh_.subscribe("/loop", 1, &Node::onLoop, this));
    subs_.push_back(nh_.subscribe("/nested", 1, &Node::onNested, this));
    timer_ = nh_.createTimer(ros::Duration(0.1), &Node::onTimer, this);
  }

  void run()
  {
    ros::Rate rate(10);
    while (ros::ok())
    {
      sendLoop(loop_);
      ros::spinOnce();
      rate.sleep();
    }
  }

private:
  void onDirect(const std_msgs::Int32& message)
  {
    direct_ = message.data;
  }

  void onLocal(const std_msgs::Int32& message)
  {
    local_ = message.data;
  }

  void onField(const std_msgs::Int32& message)
  {
    field_ = message.data;
  }

  void onElement(const std_msgs::Int32& message)
  {
    element_ = message.data;
  }

  void onPushed(const std_msgs::Int32& message)
  {
    pushed_ = message.data;
  }

  void onFilled(const std_msgs::Int32& message)
  {
    filled_ = message.data;
  }

  void onMade(const std_msgs::Int32& message)
  {
    made_ = message.data;
  }

  void onGetter(const std_msgs::Int32& message)
  {
    getter_ = message.data;
  }

  void onPassed(const std_msgs::Int32& message)
  {
    passed_ = message.data;
  }

  void onTwice(const std_msgs::Int32& message)
  {
    twice_ = message.data;
  }

  void onPointed(const std_msgs::Int32& message)
  {
    pointed_ = message.data;
  }

  void onCompared(const std_msgs::Int32& message)
  {
    compared_ = message.data;
  }

  void onUnsent(const std_msgs::Int32& message)
  {
    unsent_ = message.data;
  }

  void onLoop(const std_msgs::Int32& message)
  {
    loop_ = message.data;
  }

  void onNested(const std_msgs::Int32& message)
  {
    nested_ = message.data;
  }

  // answers at once, with what it keeps
  void onAsked(const std_msgs::Int32& message)
  {
    asked_ = message.data;
    std_msgs::Int32 answer;
    answer.data = asked_;
    other_.publish(answer);
    send(asked_);
  }

  void fill(std_msgs::Float64MultiArray& array, int)
  {
    array.layout.data_offset = filled_;
  }

  void look(std_msgs::Float64MultiArray array)
  {
    array.layout.data_offset = unsent_;
  }

  double make(int factor) const
  {
    return made_ * factor;
  }

  int getter() const
  {
    return getter_;
  }

  void send(int value)
  {
    std_msgs::Int32 message;
    message.data = value;
    helped_.publish(message);
  }

  void sendTwice(int value)
  {
    send(value * 2);
  }

  void sendLoop(int value)
  {
    std_msgs::Int32 message;
    message.data = value;
    looped_.publish(message);
    message.data = nested_;
    looped_.publish(message);
  }

  void onTimer(const ros::TimerEvent&)
  {
    std_msgs::Float64MultiArray array;
    array.layout.data_offset = direct_;
    int local = local_ + 1;
    array.data.push_back(local);
    array.layout.dim.resize(1);
    array.layout.dim[0].size = field_;
    std::vector<double> values(3);
    values[1] = element_;
    array.data = values;
    array.data.push_back(pushed_);
    fill(array, unsent_);
    look(array);
    array.data.push_back(make(3));
    array.data.push_back(getter());
    std_msgs::Float64MultiArray* pointer = &array;
    (*pointer).layout.data_offset = pointed_;
    bool same = array.layout.data_offset == compared_;
    ROS_INFO("%d %d", same, unsent_);
    out_.publish(*pointer);
    send(passed_);
    sendTwice(twice_);
  }

  ros::NodeHandle nh_;
  ros::Publisher out_, helped_, looped_, other_;
  std::vector<ros::Subscriber> subs_;
  ros::Timer timer_;
  int direct_, local_, field_, element_, pushed_, filled_, made_, getter_, passed_, twice_, pointed_, compared_, unsent_, asked_, loop_, nested_;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  Node node;
  node.run();
}
