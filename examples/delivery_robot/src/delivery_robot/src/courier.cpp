#include <delivery_msgs/Parcel.h>
#include <geometry_msgs/Twist.h>
#include <ros/ros.h>
#include <sensor_msgs/BatteryState.h>
#include <std_msgs/Bool.h>
#include <std_srvs/Trigger.h>

// Drives to the door of a parcel and asks the box to open.
class Courier
{
public:
  Courier() : private_nh_("~")
  {
    private_nh_.param("cruise_speed", cruise_speed_, 0.5);
    command_pub_ = nh_.advertise<geometry_msgs::Twist>("cmd_vel", 1);
    parcel_sub_ = nh_.subscribe("parcel", 5, &Courier::onParcel, this);
    obstacle_sub_ = nh_.subscribe("obstacles_ahead", 1, &Courier::onObstacle, this);
    battery_sub_ = nh_.subscribe("battery", 1, &Courier::onBattery, this);
    open_ = nh_.serviceClient<std_srvs::Trigger>("open_box");
  }

private:
  void onParcel(const delivery_msgs::Parcel::ConstPtr& parcel)
  {
    ROS_INFO("parcel %u for %s", parcel->id, parcel->door.c_str());
    geometry_msgs::Twist command;
    command.linear.x = blocked_ ? 0.0 : cruise_speed_;
    command_pub_.publish(command);
    std_srvs::Trigger open;
    open_.call(open);
  }

  void onObstacle(const std_msgs::Bool::ConstPtr& obstacle) { blocked_ = obstacle->data; }

  void onBattery(const sensor_msgs::BatteryState::ConstPtr& battery)
  {
    if (battery->percentage < 0.2)
      ROS_WARN("the battery is low");
  }

  ros::NodeHandle nh_;
  ros::NodeHandle private_nh_;
  ros::Publisher command_pub_;
  ros::Subscriber parcel_sub_;
  ros::Subscriber obstacle_sub_;
  ros::Subscriber battery_sub_;
  ros::ServiceClient open_;
  double cruise_speed_;
  bool blocked_ = false;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "courier");
  Courier courier;
  ros::spin();
  return 0;
}
