// Guards: nested returns, negated conjunctions, several callers, fall-through, do loops, waits at the start, chained assignments.
#include <ros/ros.h>
#include <std_msgs/Int32.h>

ros::Publisher pub;
int level = 0, copy = 0;
bool ready = false, open_door = true;

void report(const std_msgs::Int32& m)
{
  if (ready)
    pub.publish(m);
}
void nested(const std_msgs::Int32& m)
{
  if (m.data > 1)
  {
    if (m.data > 9)
      return;
  }
  level = copy = m.data;
}
void chosen(const std_msgs::Int32& m)
{
  switch (m.data)
  {
    case 1:
      level = 1;
    case 2:
      level += 2;
      break;
    default:
      level--;
  }
  if (level == 3 && copy > 0)
    report(m);
}
void other(const std_msgs::Int32& m)
{
  if (m.data == 7)
    ready = true;
  else
    do
    {
      open_door = !open_door;
    } while (m.data > 100);
  if (!open_door)
    report(m);
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "n");
  ros::NodeHandle nh;
  pub = nh.advertise<std_msgs::Int32>("out", 1);
  ros::Subscriber s1 = nh.subscribe("nested", 1, nested);
  ros::Subscriber s2 = nh.subscribe("chosen", 1, chosen);
  ros::Subscriber s3 = nh.subscribe("other", 1, other);
  while (ros::ok() && !ready)
    ros::spinOnce();
  level = 0;
  ros::spin();
}
// expect: reactive chosen -> out may [level == 3 && copy > 0 && ready]
// expect: reactive other -> out may [!open_door && ready]
// expect: state ::copy = 0
// expect: state ::level = 0
// expect: state ::open_door = true
// expect: state ::ready = false
// expect: transition ::copy . None on nested [!(m.data > 1 && m.data > 9)] := m.data
// expect: transition ::level . None on nested [!(m.data > 1 && m.data > 9)] := m.data
// expect: transition ::level . None on chosen [m.data == 1] := 1
// expect: transition ::level . None on chosen [m.data == 1 || m.data == 2] := level + 2
// expect: transition ::level . None on chosen [!(m.data == 1) && !(m.data == 2)] := level--
// expect: transition ::ready . None on other [m.data == 7] := true
// expect: transition ::open_door . None on other [!(m.data == 7)] := !open_door
