// Overloads, templates, and virtual calls through the classes that there are objects of.
// expect-not: publisher unused
#include <ros/ros.h>
#include <std_msgs/String.h>

typedef std_msgs::String M;

struct Base
{
  virtual ~Base() {}
  virtual void go(ros::NodeHandle& nh) {}
};
struct Used : Base
{
  void go(ros::NodeHandle& nh) override { nh.advertise<M>("used", 1); }  // expect: publisher used std_msgs/String
};
struct Unused : Base
{
  void go(ros::NodeHandle& nh) override { nh.advertise<M>("unused", 1); }
};

void add(ros::NodeHandle& nh, int) { nh.advertise<M>("int", 1); }  // expect: publisher int
void add(ros::NodeHandle& nh, const char*) { nh.advertise<M>("text", 1); }  // expect-not: publisher

template <class T>
void make(ros::NodeHandle& nh)
{
  nh.advertise<T>("template", 1);  // expect: publisher template std_msgs/String
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "dispatch");
  ros::NodeHandle nh;
  Base* base = new Used;
  base->go(nh);
  add(nh, 1);
  make<M>(nh);
}
