// Conditions that are constant: code that never runs has no behaviour, and what always holds is no condition.
#include <ros/ros.h>
#include <std_msgs/Int32.h>
#define TRACE 0
#define FAST 1

static const bool verbose = false;
enum { LIMIT = 0 };
ros::Publisher pub, trace;
int count = 0, traced = 0;

void onValue(const std_msgs::Int32& m)
{
  if (TRACE)
    trace.publish(m);
  if (verbose && m.data > 3)
    traced = m.data;
  if (FAST)
  {
    if (traced == 0 && ++count > 2)
      pub.publish(m);
  }
  else
    trace.publish(m);
  if (LIMIT > 0)
    return;
  do
  {
    if (m.data < 0)
      break;
    pub.publish(m);
  } while (0);
}
void onOther(const std_msgs::Int32& m)
{
  if (true || m.data > 0)
    trace.publish(m);
  return;
  pub.publish(m);
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "n");
  ros::NodeHandle nh;
  pub = nh.advertise<std_msgs::Int32>("out", 1);
  trace = nh.advertise<std_msgs::Int32>("trace", 1);
  ros::Subscriber s1 = nh.subscribe("value", 1, onValue);
  ros::Subscriber s2 = nh.subscribe("other", 1, onOther);
  ros::spin();
}
// expect: reactive value -> out may [traced == 0 && ++count > 2 || !(m.data < 0)]
// expect: reactive other -> trace must []
// expect: state ::count = 0
// expect: transition ::count . None on value [traced == 0] := ++count
