// What a condition depends on: arguments that a function's result is made from, local variables filled part by part, elements of what is stored.
#include <cmath>
#include <vector>
#include <ros/ros.h>
#include <geometry_msgs/Point.h>
#include <std_msgs/Int32.h>

struct Step
{
  double x, y;
};

ros::Publisher moved, far_off, listed, sent;
geometry_msgs::Point last_place, origin, anchor;
double height = 0;
std::vector<int> wanted;
int label = 0;

double distance(const geometry_msgs::Point& a, const geometry_msgs::Point& b)
{
  double dx = a.x - b.x;
  double dy = a.y - b.y;
  return std::sqrt(dx * dx + dy * dy);
}
// what it returns hangs on the place, not on the label
bool near(const geometry_msgs::Point& place, int label)
{
  if (label > 3)
    ROS_INFO("label %d", label);
  if (place.x < 1.0)
    return true;
  return false;
}
void onPlace(const geometry_msgs::Point& m)
{
  if (distance(m, last_place) > 0.5)
  {
    moved.publish(m);
    last_place = m;
  }
}
void onOrigin(const geometry_msgs::Point& m)
{
  origin = m;
  height = m.z;
}
void onStep(const geometry_msgs::Point& m)
{
  Step step;
  step.x = m.x - origin.x;
  step.y = m.y - height;
  if (std::fabs(step.x) > 1.0)
    far_off.publish(m);
}
void onWanted(const std_msgs::Int32& m) { wanted.push_back(m.data); }
void onNumber(const std_msgs::Int32& m)
{
  for (int value : wanted)
    if (value == m.data)
      listed.publish(m);
}
void onAnchor(const geometry_msgs::Point& m) { anchor = m; }
void onLabel(const std_msgs::Int32& m) { label = m.data; }
void onCheck(const geometry_msgs::Point& m)
{
  bool close = near(anchor, label);
  if (close)
    sent.publish(m);
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "n");
  ros::NodeHandle nh;
  moved = nh.advertise<geometry_msgs::Point>("moved", 1);
  far_off = nh.advertise<geometry_msgs::Point>("far_off", 1);
  listed = nh.advertise<std_msgs::Int32>("listed", 1);
  sent = nh.advertise<geometry_msgs::Point>("sent", 1);
  ros::Subscriber s0 = nh.subscribe("place", 1, onPlace);
  ros::Subscriber s1 = nh.subscribe("origin", 1, onOrigin);
  ros::Subscriber s2 = nh.subscribe("step", 1, onStep);
  ros::Subscriber s3 = nh.subscribe("wanted", 1, onWanted);
  ros::Subscriber s4 = nh.subscribe("number", 1, onNumber);
  ros::Subscriber s5 = nh.subscribe("anchor", 1, onAnchor);
  ros::Subscriber s6 = nh.subscribe("label", 1, onLabel);
  ros::Subscriber s7 = nh.subscribe("check", 1, onCheck);
  ros::spin();
}
// expect: reactive place -> moved may [distance(m, last_place) > 0.5]
// expect: reactive step -> far_off may [std::fabs(step.x) > 1.0]
// expect: reactive number -> listed may [value == m.data]
// expect: reactive check -> sent may [close]
// expect: state ::anchor = None
// expect: state ::last_place = None
// expect: state ::origin = None
// expect: state ::wanted = None
// expect: transition ::anchor . None on anchor [] := m
// expect: transition ::last_place . None on place [distance(m, last_place) > 0.5] := m
// expect: transition ::origin . None on origin [] := m
// expect: transition ::wanted . None on wanted [] := wanted.push_back(m.data)
