#include <geometry_msgs/Twist.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <std_srvs/SetBool.h>

// Drives forwards to the end of the corridor and backwards to its beginning.
class Patrol
{
public:
  Patrol() : private_nh_("~")
  {
    private_nh_.param("speed", speed_, 0.4);
    private_nh_.param("length", length_, 5.0);
    command_pub_ = nh_.advertise<geometry_msgs::Twist>("cmd_vel", 1);
    odometry_sub_ = nh_.subscribe("odom", 5, &Patrol::onOdometry, this);
    enable_server_ = private_nh_.advertiseService("enable", &Patrol::onEnable, this);
  }

private:
  void onOdometry(const nav_msgs::Odometry::ConstPtr& odometry)
  {
    const double x = odometry->pose.pose.position.x;
    if (x > length_)
      forwards_ = false;
    else if (x < 0.0)
      forwards_ = true;
    if (!enabled_)
      return;
    geometry_msgs::Twist command;
    command.linear.x = forwards_ ? speed_ : -speed_;
    command_pub_.publish(command);
  }

  bool onEnable(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response)
  {
    enabled_ = request.data;
    response.success = true;
    return true;
  }

  ros::NodeHandle nh_;
  ros::NodeHandle private_nh_;
  ros::Publisher command_pub_;
  ros::Subscriber odometry_sub_;
  ros::ServiceServer enable_server_;
  double speed_;
  double length_;
  bool forwards_ = true;
  bool enabled_ = false;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "patrol");
  Patrol patrol;
  ros::spin();
  return 0;
}
