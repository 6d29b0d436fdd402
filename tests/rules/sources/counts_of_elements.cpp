// A round over objects of several classes lets each of them send once; one over objects of one class lets them send as often as there are objects.
// expect: answers_most([_, _, "/in"], [_, _, "/speed"], "1")
// expect: answers_most([_, _, "/in"], [_, _, "/power"], "1")
// expect: answers_most([_, _, "/in"], [_, _, "/wheel"], "many")
// expect: sends_in_burst(_, [_, _, "/wheel"], "many")
// expect: 1 = count : { sends_in_burst(_, _, _) }
#include <memory>
#include <vector>
#include <ros/ros.h>
#include <std_msgs/Int32.h>

struct Sensor
{
  virtual ~Sensor() = default;
  virtual void send(const std_msgs::Int32& message) = 0;
};

struct Speed : Sensor
{
  explicit Speed(ros::NodeHandle& nh) : pub_(nh.advertise<std_msgs::Int32>("/speed", 1)) {}
  void send(const std_msgs::Int32& message) override { pub_.publish(message); }
  ros::Publisher pub_;
};

struct Power : Sensor
{
  explicit Power(ros::NodeHandle& nh) : pub_(nh.advertise<std_msgs::Int32>("/power", 1)) {}
  void send(const std_msgs::Int32& message) override { pub_.publish(message); }
  ros::Publisher pub_;
};

struct Wheel
{
  explicit Wheel(ros::NodeHandle& nh) : pub_(nh.advertise<std_msgs::Int32>("/wheel", 1)) {}
  void send(const std_msgs::Int32& message) { pub_.publish(message); }
  ros::Publisher pub_;
};

std::vector<std::shared_ptr<Sensor>> sensors;
std::vector<Wheel> wheels;

void onIn(const std_msgs::Int32& message)
{
  for (const auto& sensor : sensors)
    sensor->send(message);
  for (auto& wheel : wheels)
    wheel.send(message);
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "elements");
  ros::NodeHandle nh;
  sensors.push_back(std::make_shared<Speed>(nh));
  sensors.push_back(std::make_shared<Power>(nh));
  wheels.emplace_back(nh);
  wheels.emplace_back(nh);
  ros::Subscriber sub = nh.subscribe("/in", 1, onIn);
  ros::spin();
}
