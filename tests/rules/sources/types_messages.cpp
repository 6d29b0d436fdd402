// Which messages ports carry, whatever their types are behind.
//
// expect: N = count : { expr_class(E, "Board"), location(E, File, Line, Column) }, N = 14
// expect: N = count : { variable_class(V, "Board") }, N = 4
// expect: N = count : { class_instance(Class, Instance), location(Class, File, Line, Column) }, N = 2
// expect: N = count : { variable_type(V, Type), type_holds_instance(Type, "Relay<std_msgs::String_>") }, N = 2
// expect-only: subscriber
// expect-only: publisher
// expect: 1 = count : { value_goes(_, _, _) }
#include <boost/make_shared.hpp>
#include <memory>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <std_msgs/Int32.h>
#include <std_msgs/String.h>
#include <vector>

class Board
{
public:
  void onText(const std_msgs::String::ConstPtr& message)
  {
  }
  void onShared(const boost::shared_ptr<std_msgs::Int32 const>& message)
  {
  }
  void onEvent(const ros::MessageEvent<sensor_msgs::Image const>& event)
  {
  }
  void onValue(std_msgs::Int32 message)
  {
    ++count_;
  }
  Board* self()
  {
    return this;
  }
  int count_ = 0;
};

template <class Message>
class Relay
{
public:
  explicit Relay(ros::NodeHandle& nh)
  {
    sub_ = nh.subscribe("/relay_in", 1, &Relay::onMessage, this);  // expect: subscriber /relay_in std_msgs/String
    pub_ = nh.advertise<Message>("/relay_out", 1);  // expect: publisher /relay_out std_msgs/String
  }
  void onMessage(const typename Message::ConstPtr& message)
  {
    pub_.publish(message);
  }

private:
  ros::Subscriber sub_;
  ros::Publisher pub_;
};

class TextRelay : public Relay<std_msgs::String>
{
public:
  explicit TextRelay(ros::NodeHandle& nh) : Relay<std_msgs::String>(nh)
  {
  }
};

class NamedRelay : public TextRelay
{
public:
  explicit NamedRelay(ros::NodeHandle& nh) : TextRelay(nh)
  {
  }
};

void onText(const std_msgs::StringConstPtr& message)
{
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  Board board;
  Board* pointer = &board;
  Board& reference = *pointer;
  std::shared_ptr<Board> shared = std::make_shared<Board>();
  const std::vector<Board> boards(2);
  NamedRelay relay(nh);
  Relay<std_msgs::String>* base = &relay;
  const std::shared_ptr<Relay<std_msgs::String>> kept(new Relay<std_msgs::String>(nh));
  const std::vector<Relay<std_msgs::String>> several;
  std::vector<ros::Subscriber> subs;
  subs.push_back(nh.subscribe("/text", 1, &Board::onText, &board));  // expect: subscriber /text std_msgs/String callback=Board::onText
  subs.push_back(nh.subscribe("/shared", 1, &Board::onShared, pointer));  // expect: subscriber /shared std_msgs/Int32
  subs.push_back(nh.subscribe("/event", 1, &Board::onEvent, shared.get()));  // expect: subscriber /event sensor_msgs/Image
  subs.push_back(nh.subscribe("/value", 1, &Board::onValue, reference.self()));  // expect: subscriber /value std_msgs/Int32
  subs.push_back(nh.subscribe("/free", 1, onText));  // expect: subscriber /free std_msgs/String callback=onText
  ros::spin();
}
