// What is always sent, and what only sometimes, through functions, loops, exceptions and ports that are handed on.
//
// expect: reactive /relay -> /relayed must
// expect: reactive /relay_sometimes -> /relayed may
// expect: reactive /twice -> /out must
// expect: reactive /never_sure -> /out may
// expect: reactive /last -> /out must
// expect: reactive /choice -> /left may
// expect: reactive /choice -> /right may
// expect: reactive /both -> /left must
// expect: reactive /both -> /right must
// expect: reactive /each -> /out may
// expect: reactive /some -> /out may
// expect: reactive /found -> /out may
// expect: reactive /do -> /out must
// expect: reactive /forever -> /out must
// expect: reactive /caught -> /out may
// expect: reactive /thrown -> /out may
// expect: reactive /recovered -> /out must
// expect: reactive /harmless -> /out must
// expect: reactive /behaviour -> /out may
// expect: reactive /switch -> /out must
// expect: reactive /switch_open -> /out may
// expect: reactive /transformed -> /out may
// expect: reactive /plain -> /out must
// expect: reactive /repeat -> /out may
// expect-only: reactive
// expect: Count = count : { may_skip(F, Kind, Name), Kind != "parameter" }, Count = 21
// expect: 27 = count : { port_flow(_, _, _, _) }
#include <message_filters/subscriber.h>
#include <ros/ros.h>
#include <std_msgs/Int32.h>
#include <tf/message_filter.h>
#include <tf/transform_listener.h>
#include <vector>

typedef std_msgs::Int32 Message;

ros::Publisher g_out, g_relayed, g_left, g_right;
std::vector<int> g_numbers;

int risky(int number);

void relay(ros::Publisher& pub, const Message& message)
{
  pub.publish(message);
}

void relaySometimes(const ros::Publisher& pub, const Message& message)
{
  if (message.data > 0)
    pub.publish(message);
}

void onRelay(const Message& message)
{
  relay(g_relayed, message);
}

void onRelaySometimes(const Message& message)
{
  relaySometimes(g_relayed, message);
}

void maybe(const Message& message)
{
  if (message.data > 1)
    g_out.publish(message);
}

void onTwice(const Message& message)
{
  maybe(message);
  g_out.publish(message);
}

void onNeverSure(const Message& message)
{
  maybe(message);
  maybe(message);
}

void onLast(const Message& message)
{
  maybe(message);
  maybe(message);
  g_out.publish(message);
  maybe(message);
}

void onChoice(const Message& message)
{
  ros::Publisher& pub = message.data ? g_left : g_right;
  pub.publish(message);
}

void onBoth(const Message& message)
{
  relay(g_left, message);
  relay(g_right, message);
}

void onEach(const Message& message)
{
  for (int number : g_numbers)
    g_out.publish(message);
}

void onSome(const Message& message)
{
  for (int number : g_numbers)
  {
    if (number > message.data)
      g_out.publish(message);
  }
}

void onFound(const Message& message)
{
  for (int number : g_numbers)
  {
    if (number > message.data)
      break;
    g_out.publish(message);
  }
}

void onDo(const Message& message)
{
  int number = 0;
  do
  {
    g_out.publish(message);
  } while (++number < message.data);
}

void onForever(const Message& message)
{
  for (;;)
  {
    g_out.publish(message);
    if (message.data > 3)
      break;
  }
}

void onCaught(const Message& message)
{
  try
  {
    risky(message.data);
    g_out.publish(message);
  }
  catch (const std::exception& error)
  {
    ROS_WARN("%s", error.what());
  }
}

void onThrown(const Message& message)
{
  try
  {
    if (message.data < 0)
      throw std::runtime_error("negative");
    g_out.publish(message);
  }
  catch (const std::exception& error)
  {
    ROS_WARN("%s", error.what());
  }
}

void onRecovered(const Message& message)
{
  try
  {
    risky(message.data);
  }
  catch (const std::exception& error)
  {
    g_out.publish(message);
    return;
  }
  g_out.publish(message);
}

void onHarmless(const Message& message)
{
  try
  {
    g_out.publish(message);
  }
  catch (const std::exception&)
  {
  }
}

struct Behaviour
{
  virtual ~Behaviour() {}
  virtual void act(const Message& message)
  {
    g_out.publish(message);
  }
};

struct Lazy : Behaviour
{
  void act(const Message&) override
  {
  }
};

std::vector<Behaviour*> g_behaviours;

void onBehaviour(const Message& message)
{
  g_behaviours.front()->act(message);
}

void onSwitch(const Message& message)
{
  switch (message.data)
  {
    case 1:
      g_out.publish(message);
      break;
    default:
      maybe(message);
      g_out.publish(message);
  }
}

void onSwitchOpen(const Message& message)
{
  switch (message.data)
  {
    case 1:
      g_out.publish(message);
      break;
    case 2:
      g_out.publish(message);
      break;
  }
}

void onTransformed(const Message::ConstPtr& message)
{
  g_out.publish(message);
}

void onPlain(const Message::ConstPtr& message)
{
  g_out.publish(message);
}

void repeat(const Message& message, int times)
{
  if (times == 0)
    return;
  g_out.publish(message);
  repeat(message, times - 1);
}

void onRepeat(const Message& message)
{
  repeat(message, message.data);
}

// nobody calls it
void unused(const Message& message)
{
  maybe(message);
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  g_out = nh.advertise<Message>("/out", 1);
  g_relayed = nh.advertise<Message>("/relayed", 1);
  g_left = nh.advertise<Message>("/left", 1);
  g_right = nh.advertise<Message>("/right", 1);
  g_behaviours.push_back(new Behaviour);
  g_behaviours.push_back(new Lazy);
  std::vector<ros::Subscriber> subs;
  subs.push_back(nh.subscribe("/relay", 1, onRelay));
  subs.push_back(nh.subscribe("/relay_sometimes", 1, onRelaySometimes));
  subs.push_back(nh.subscribe("/twice", 1, onTwice));
  subs.push_back(nh.subscribe("/never_sure", 1, onNeverSure));
  subs.push_back(nh.subscribe("/last", 1, onLast));
  subs.push_back(nh.subscribe("/choice", 1, onChoice));
  subs.push_back(nh.subscribe("/both", 1, onBoth));
  subs.push_back(nh.subscribe("/each", 1, onEach));
  subs.push_back(nh.subscribe("/some", 1, onSome));
  subs.push_back(nh.subscribe("/found", 1, onFound));
  subs.push_back(nh.subscribe("/do", 1, onDo));
  subs.push_back(nh.subscribe("/forever", 1, onForever));
  subs.push_back(nh.subscribe("/caught", 1, onCaught));
  subs.push_back(nh.subscribe("/thrown", 1, onThrown));
  subs.push_back(nh.subscribe("/recovered", 1, onRecovered));
  subs.push_back(nh.subscribe("/harmless", 1, onHarmless));
  subs.push_back(nh.subscribe("/behaviour", 1, onBehaviour));
  subs.push_back(nh.subscribe("/switch", 1, onSwitch));
  subs.push_back(nh.subscribe("/switch_open", 1, onSwitchOpen));
  subs.push_back(nh.subscribe("/repeat", 1, onRepeat));
  tf::TransformListener listener;
  message_filters::Subscriber<Message> filtered_sub(nh, "/transformed", 1);
  tf::MessageFilter<Message> filter(filtered_sub, listener, "base", 10);
  filter.registerCallback(onTransformed);
  message_filters::Subscriber<Message> plain_sub(nh, "/plain", 1);
  plain_sub.registerCallback(onPlain);
  ros::spin();
}
