// Local variables in conditions: replaced by what they stand for where that is exact, and conditions in negation normal form.
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_msgs/Int32.h>

ros::Publisher pub;
bool enabled = false;
int level = 0, limit_reached = 0;

bool read(int& value);

void onValue(const std_msgs::Int32& m)
{
  const bool high = m.data > level, big = m.data > 9;
  bool wanted = big && enabled && !high;
  if (wanted == true)
    pub.publish(m);
  bool late = level > 3;
  level = m.data;
  if (late)
    pub.publish(m);
}
void onOther(const std_msgs::Int32& m)
{
  int size = 0;
  bool ok = size > 2;
  if (!read(size) || !(m.data == 3 || enabled == false))
    return;
  if (ok && size)
    limit_reached = 1;
}
void onEnable(const std_msgs::Bool& m)
{
  int before = limit_reached;
  switch (before)
  {
    case 1:
      enabled = m.data;
  }
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "n");
  ros::NodeHandle nh;
  pub = nh.advertise<std_msgs::Int32>("out", 1);
  ros::Subscriber s1 = nh.subscribe("value", 1, onValue);
  ros::Subscriber s2 = nh.subscribe("other", 1, onOther);
  ros::Subscriber s3 = nh.subscribe("enable", 1, onEnable);
  ros::spin();
}
// expect: reactive value -> out may [wanted == true || late]
// expect: state ::enabled = false
// expect: state ::level = 0
// expect: state ::limit_reached = 0
// expect: transition ::level . None on value [] := m.data
// expect: transition ::limit_reached . None on other [!(!read(size) || !(m.data == 3 || enabled == false)) && ok && size] := 1
// expect: transition ::enabled . None on enable [before == 1] := m.data
// normal: reactive value -> out [(m.data > 9 && enabled && !high) || late]
// normal: transition ::level on value []
// normal: transition ::limit_reached on other [read(size) && (m.data == 3 || !enabled) && ok && size]
// normal: transition ::enabled on enable [limit_reached == 1]
