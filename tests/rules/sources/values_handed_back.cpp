// A variable that a setter gives what the caller made of the variable itself: there is no end of its values.
//
// expect: N = count : { feeds_itself(_) }, N = 1
// expect: defined_text(D, _, _, "?", ""), feeds_itself(D)
// expect-only: publisher
// expect: publisher after_50_5
// expect: publisher after_50_7
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <string>

class Limits
{
public:
  void set(int given, int other)
  {
    rounds_ = given;
    seconds_ = other;
  }

  int rounds_ = 50;
  int seconds_ = 5;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "limits");
  ros::NodeHandle nh;
  Limits limits;
  while (ros::ok()) {
    auto pub = nh.advertise<std_msgs::Empty>("after_" + std::to_string(limits.rounds_) + "_" + std::to_string(limits.seconds_), 1);
    limits.set(limits.rounds_ + 50, 7);
  }
}
