// What a callback keeps reaches what a timer sends through arguments, helpers that fill a message, and what functions return.
#include <ros/ros.h>
#include <geometry_msgs/Twist.h>
#include <std_msgs/Float64.h>
#include <std_msgs/Int32.h>

double speed = 0, turn = 0, height = 0, level = 0, shown = 0, other = 0;
ros::Publisher cmd, lift, tank, lamp;

void keep(double& target, double value) { target = value; }
void onSpeed(const std_msgs::Float64& m) { keep(speed, m.data); }
void onTurn(const std_msgs::Float64& m) { turn = m.data; }
void onHeight(const std_msgs::Float64& m) { height = m.data; }
void onLevel(const std_msgs::Float64& m) { level = m.data; }
void onOther(const std_msgs::Float64& m) { other = m.data; }

void send(double x, double z)
{
  geometry_msgs::Twist twist;
  twist.linear.x = x;
  twist.angular.z = z;
  cmd.publish(twist);
}
void drive(double x, double z) { send(2 * x, z); }
void fill(std_msgs::Float64& message, double value) { message.data = value; }
std_msgs::Float64 measured()
{
  std_msgs::Float64 result;
  result.data = level;
  return result;
}
void show(double value)
{
  std_msgs::Float64 message;
  message.data = value;
  lamp.publish(message);
}
void onShow(const std_msgs::Float64& m)
{
  shown = m.data;
  show(other);
}
void onTimer(const ros::TimerEvent&)
{
  double bounded = turn > 1 ? 1 : turn;
  drive(speed, bounded);
  std_msgs::Float64 message;
  fill(message, height);
  lift.publish(message);
  tank.publish(measured());
  show(1.0);
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "n");
  ros::NodeHandle nh;
  cmd = nh.advertise<geometry_msgs::Twist>("cmd", 1);
  lift = nh.advertise<std_msgs::Float64>("lift", 1);
  tank = nh.advertise<std_msgs::Float64>("tank", 1);
  lamp = nh.advertise<std_msgs::Float64>("lamp", 1);
  ros::Subscriber s1 = nh.subscribe("speed", 1, onSpeed);
  ros::Subscriber s2 = nh.subscribe("turn", 1, onTurn);
  ros::Subscriber s3 = nh.subscribe("height", 1, onHeight);
  ros::Subscriber s4 = nh.subscribe("level", 1, onLevel);
  ros::Subscriber s5 = nh.subscribe("other", 1, onOther);
  ros::Subscriber s6 = nh.subscribe("show", 1, onShow);
  ros::Timer timer = nh.createTimer(ros::Duration(0.1), onTimer);
  ros::spin();
}
// expect: periodic timer 10.0 None cmd,lift,tank,lamp []
// expect: reactive show -> lamp must []
// expect: deferred speed -> cmd by ::speed
// expect: deferred turn -> cmd by ::turn
// expect: deferred height -> lift by ::height
// expect: deferred level -> tank by ::level
