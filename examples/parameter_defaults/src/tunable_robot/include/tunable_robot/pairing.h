#ifndef TUNABLE_ROBOT_PAIRING_H
#define TUNABLE_ROBOT_PAIRING_H

#include <string>

#include <ros/ros.h>

// Hands on a message of each of two inputs, whichever is the newer.
template <typename First, typename Second, typename Names>
class Pairing
{
public:
  explicit Pairing(const std::string& prefix);
  void run();

private:
  void onFirst(const typename First::ConstPtr& message);
  void onSecond(const typename Second::ConstPtr& message);

  ros::Subscriber first_sub_, second_sub_;
  ros::Publisher first_pub_, second_pub_;
};

#include "tunable_robot/pairing_impl.h"

#endif
