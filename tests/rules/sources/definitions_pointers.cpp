// Which functions change what their parameters point or refer to.
//
// expect: publisher /put
// expect: publisher /kept
// expect: publisher /filled
// expect-only: publisher
// expect: 2 = count : { written_through(_) }, 3 = count : { parameter_changed(_, _) }, 1 = count : { mutable_reference(_) }
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <string>

void put(std::string* out, int)
{
  *out = "/put";
}

bool look(std::string* in, std::string* unused)
{
  std::string seen = *in;
  return *in == seen;
}

void pick(const char* text, int* numbers)
{
  numbers[0] = 1;
}

void fill(std::string& out, const std::string& in)
{
  out = "/filled";
  std::string copy = in;
  copy = "";
}

void byValue(std::string copied)
{
  copied = "/never";
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "pointers");
  ros::NodeHandle nh;
  int numbers[2];
  std::string name = "/before", kept = "/kept", filled = "/empty";
  put(&name, 1);
  look(&kept, &kept);
  byValue(kept);
  pick("/text", numbers);
  fill(filled, kept);
  ros::Publisher pub = nh.advertise<std_msgs::Empty>(name, 1);
  ros::Publisher kept_pub = nh.advertise<std_msgs::Empty>(kept, 1);
  ros::Publisher filled_pub = nh.advertise<std_msgs::Empty>(filled, 1);
  ros::spin();
}
