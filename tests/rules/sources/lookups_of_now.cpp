// Look-ups of tf for the present moment: without a wait, with one before, and for the latest transform.
//
// expect: 1 = count : { transform_of_now(_) }
// expect: transform_of_now(C), location(C, _, 13, _)
#include <ros/ros.h>
#include <tf/transform_listener.h>

void look(tf::TransformListener& listener) {
  tf::StampedTransform t;
  // the latest one
  listener.lookupTransform("map", "base", ros::Time(0), t);
  // the present moment
  listener.lookupTransform("map", "base", ros::Time::now(), t);
}

void wait(tf::TransformListener& listener) {
  tf::StampedTransform t;
  ros::Time now = ros::Time::now();
  listener.waitForTransform("map", "base", now, ros::Duration(1));
  listener.lookupTransform("map", "base", now, t);
}

int main(int argc, char** argv) {
  ros::init(argc, argv, "look");
  tf::TransformListener listener;
  ros::Rate rate(1);
  while (ros::ok()) {
    look(listener);
    wait(listener);
    rate.sleep();
  }
}
