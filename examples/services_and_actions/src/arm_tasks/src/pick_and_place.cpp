#include <geometry_msgs/PoseStamped.h>
#include <ros/ros.h>
#include <std_msgs/UInt32.h>

#include "arm_client.h"

namespace
{
enum class State
{
  Waiting,
  Picking,
  Placing,
};

class PickAndPlace
{
public:
  PickAndPlace() : arm_(nh_, "arm")
  {
    object_sub_ = nh_.subscribe("detected_object", 1, &PickAndPlace::onObject, this);
    count_pub_ = nh_.advertise<std_msgs::UInt32>("placed_objects", 1, true);
    ros::param::param("~place_x", place_.position.x, 0.4);
    ros::param::get("~place_y", place_.position.y);
  }

  void step()
  {
    switch (state_)
    {
      case State::Waiting:
        break;
      case State::Picking:
        state_ = arm_.setGripper(0.08) && arm_.moveTo(object_) && arm_.setGripper(0.0) ? State::Placing : State::Waiting;
        break;
      case State::Placing:
        if (arm_.moveTo(place_) && arm_.setGripper(0.08))
        {
          ++count_.data;
          count_pub_.publish(count_);
        }
        arm_.home();
        state_ = State::Waiting;
        break;
    }
  }

private:
  void onObject(const geometry_msgs::PoseStamped& object)
  {
    if (state_ != State::Waiting)
      return;
    object_ = object.pose;
    state_ = State::Picking;
  }

  ros::NodeHandle nh_;
  arm_tasks::ArmClient arm_;
  ros::Subscriber object_sub_;
  ros::Publisher count_pub_;

  State state_ = State::Waiting;
  geometry_msgs::Pose object_;
  geometry_msgs::Pose place_;
  std_msgs::UInt32 count_;
};
}  // namespace

int main(int argc, char** argv)
{
  ros::init(argc, argv, "pick_and_place");
  PickAndPlace task;
  ros::Rate rate(10);
  while (ros::ok())
  {
    ros::spinOnce();
    task.step();
    rate.sleep();
  }
  return 0;
}
