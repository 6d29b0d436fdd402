// Fields whose values come back to them changed, through calls: there is no end of these values. What only looks like it keeps its texts.
//
// expect: grows("Counted::count_")
// expect: grows("Counted::name_")
// expect: grows("Point::parts_")
// expect-not: grows("Named::first_")
// expect-not: grows("Named::second_")
// expect: publisher /robot/left/right
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <string>

class Counted
{
public:
  void set(int count) { count_ = count; }
  int get() const { return count_; }
  void call(const std::string& name) { name_ = name; }
  const std::string& name() const { return name_; }

private:
  int count_ = 1;
  std::string name_ = "a";
};

// by reference, into an element
class Point
{
public:
  explicit Point(int first) { convert(first, parts_[0]); }
  int operator[](int index) const { return parts_[index]; }

private:
  static void convert(int from, int& to) { to = from; }
  int parts_[2];
};

// one helper makes both: what it makes of the first does not come back to it
class Named
{
public:
  static std::string join(const std::string& name, const std::string& end) { return name + "/" + end; }
  Named() : first_(join("/robot", "left")) { second_ = join(first_, "right"); }
  const std::string& name() const { return second_; }

private:
  std::string first_, second_;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "growing");
  ros::NodeHandle nh;
  Counted counted;
  counted.set(counted.get() + 1);
  counted.call(counted.name() + "b");
  ros::Publisher grown = nh.advertise<std_msgs::Empty>(counted.name(), counted.get());
  Point point(3);
  Point next(point[0] + point[1]);
  ros::Publisher far = nh.advertise<std_msgs::Empty>("far", next[0]);
  Named named;
  ros::Publisher plain = nh.advertise<std_msgs::Empty>(named.name(), 2);
  grown.publish(std_msgs::Empty());
  far.publish(std_msgs::Empty());
  plain.publish(std_msgs::Empty());
  ros::spin();
}
