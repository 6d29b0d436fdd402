// Control: exceptions, do loops, lambdas, several callers, short circuit, gotos out of loops, function statics, null pointers, containers.
#include <algorithm>
#include <deque>
#include <stdexcept>
#include <vector>
#include <boost/shared_ptr.hpp>
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_msgs/Int32.h>

ros::Publisher out, bell;
std_msgs::Int32::ConstPtr last;
std::deque<int> queue_;
std::vector<int> seen;
bool broken = false, asked = false;
int tries = 0;

int parse(int value);

void thrown(const std_msgs::Int32& m)
{
  try
  {
    if (m.data < 0)
      throw std::runtime_error("negative");
    out.publish(m);  // may throw as well
  }
  catch (const std::runtime_error&)
  {
    broken = true;
  }
}
void repeated(const std_msgs::Int32& m)
{
  do
  {
    ++tries;
  } while (parse(m.data) != 0 && tries < 3);
  if (tries >= 3)
    bell.publish(m);
}
void each(const std_msgs::Int32& m)
{
  std::for_each(seen.begin(), seen.end(), [&](int value) {
    if (value == m.data)
      bell.publish(m);
  });
  auto send = [&]() { out.publish(m); };
  if (!seen.empty())
    send();
}
void report(const std_msgs::Int32& m)
{
  if (!broken)
    bell.publish(m);
}
void first(const std_msgs::Int32& m)
{
  if (m.data == 1)
    report(m);
  else if (asked)
    report(m);
}
bool tell(const std_msgs::Int32& m)
{
  out.publish(m);
  return true;
}
void shortened(const std_msgs::Int32& m)
{
  asked && tell(m);
}
void held(const std_msgs::Int32::ConstPtr& m)
{
  if (last && last->data == m->data)
    return;
  last = m;
  static bool warned = false;
  if (!warned)
  {
    bell.publish(*m);
    warned = true;
  }
}
void queued(const std_msgs::Int32& m)
{
  queue_.push_back(m.data);
  if (queue_.size() > 4)
    queue_.pop_front();
  while (!queue_.empty())
  {
    out.publish(m);
    queue_.pop_front();
  }
}
void remembered(const std_msgs::Int32& m) { seen.push_back(m.data); }
void ask(const std_msgs::Bool& m) { asked = m.data; }

int main(int argc, char** argv)
{
  ros::init(argc, argv, "n");
  ros::NodeHandle nh;
  out = nh.advertise<std_msgs::Int32>("out", 1);
  bell = nh.advertise<std_msgs::Int32>("bell", 1);
  ros::Subscriber s0 = nh.subscribe("thrown", 1, thrown);
  ros::Subscriber s1 = nh.subscribe("repeated", 1, repeated);
  ros::Subscriber s2 = nh.subscribe("each", 1, each);
  ros::Subscriber s3 = nh.subscribe("first", 1, first);
  ros::Subscriber s4 = nh.subscribe("shortened", 1, shortened);
  ros::Subscriber s5 = nh.subscribe("held", 1, held);
  ros::Subscriber s6 = nh.subscribe("queued", 1, queued);
  ros::Subscriber s7 = nh.subscribe("remembered", 1, remembered);
  ros::Subscriber s8 = nh.subscribe("ask", 1, ask);
  ros::spin();
}
// expect: reactive thrown -> out may [!(m.data < 0)]
// expect: reactive repeated -> bell may [tries >= 3]
// expect: reactive each -> bell may [value == m.data]
// expect: reactive each -> out may [!seen.empty()]
// expect: reactive first -> bell may [!broken && (m.data == 1 || asked)]
// expect: reactive shortened -> out may [asked]
// expect: reactive held -> bell may [!(last && last->data == m->data) && !warned]
// expect: reactive queued -> out may [!queue_.empty()]
// expect: state ::asked = false
// expect: state ::broken = false
// expect: state ::last = None
// expect: state ::queue_ = None
// expect: state ::seen = None
// expect: state ::tries = 0
// expect: state held::warned = false
// expect: transition ::asked . None on ask [] := m.data
// expect: transition ::broken . None on thrown [] := true
// expect: transition ::last . None on held [!(last && last->data == m->data)] := m
// expect: transition ::queue_ . None on queued [!queue_.empty()] := queue_.pop_front()
// expect: transition ::queue_ . None on queued [] := queue_.push_back(m.data)
// expect: transition ::queue_ . None on queued [queue_.size() > 4] := queue_.pop_front()
// expect: transition ::seen . None on remembered [] := seen.push_back(m.data)
// expect: transition ::tries . None on repeated [] := ++tries
// expect: transition held::warned . None on held [!(last && last->data == m->data) && !warned] := true
