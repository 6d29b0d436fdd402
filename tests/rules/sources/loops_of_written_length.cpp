// Loops that run as often as is written: so often they send; not those whose counter the body changes, that end before, or whose bound is
// not known, nor through several publishers of one name.
//
// expect: answers_most([_, _, "/in"], [_, _, "/twice"], "2")
// expect: answers_least([_, _, "/in"], [_, _, "/twice"], "2")
// expect: answers_most([_, _, "/in"], [_, _, "/thrice"], "3")
// expect: answers_least([_, _, "/in"], [_, _, "/thrice"], "3")
// expect: answers_most([_, _, "/in"], [_, _, "/changed"], "many")
// expect: answers_most([_, _, "/in"], [_, _, "/left"], "many")
// expect: answers_most([_, _, "/in"], [_, _, "/long"], "many")
// expect: answers_most([_, _, "/in"], [_, _, "/odd"], "4")
// expect: round_least(_, [_, _, "/beat"], "5")
// expect-not: answers_least(_, [_, _, "/both"], _)
// expect: 2 = count : { answers_least(_, _, _) }
#include <ros/ros.h>
#include <std_msgs/Int32.h>

ros::Publisher twice, thrice, changed, left_early, longer, odd, beat, one, other;

void onIn(const std_msgs::Int32& m) {
  for (int i = 0; i < 2; ++i) twice.publish(m);
  thrice.publish(m);
  thrice.publish(m);
  thrice.publish(m);
  for (int i = 0; i < 2; ++i) {
    changed.publish(m);
    if (m.data > 3) i = 0;
  }
  for (int i = 0; i < 9; ++i) {
    left_early.publish(m);
    if (m.data > i) break;
  }
  for (int i = 0; i < m.data; ++i) longer.publish(m);
  for (int i = 0; i < 4; ++i)
    if (i % 2) odd.publish(m);
  for (int i = 0; i < 2; ++i) {
    one.publish(m);
    other.publish(m);
  }
}

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  twice = nh.advertise<std_msgs::Int32>("/twice", 10);
  thrice = nh.advertise<std_msgs::Int32>("/thrice", 10);
  changed = nh.advertise<std_msgs::Int32>("/changed", 10);
  left_early = nh.advertise<std_msgs::Int32>("/left", 10);
  longer = nh.advertise<std_msgs::Int32>("/long", 10);
  odd = nh.advertise<std_msgs::Int32>("/odd", 10);
  beat = nh.advertise<std_msgs::Int32>("/beat", 10);
  one = nh.advertise<std_msgs::Int32>("/both", 10);
  other = nh.advertise<std_msgs::Int32>("/both", 10);
  ros::Subscriber sub = nh.subscribe("/in", 1, onIn);
  ros::Rate rate(10);
  while (ros::ok()) {
    for (int i = 0; i < 5; i++) beat.publish(std_msgs::Int32());
    ros::spinOnce();
    rate.sleep();
  }
}
