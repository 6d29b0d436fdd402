// A program that joins its thread when ROS has ended.
//
// expect: publisher heat
// expect-not: joins_endless(_, _, _)
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <thread>

class Oven {
public:
  Oven() : pub_(nh_.advertise<std_msgs::Bool>("heat", 1)), thread_(&Oven::bake, this) {}
  ~Oven() { thread_.join(); }

private:
  void bake() {
    ros::Rate rate(10);
    while (ros::ok()) rate.sleep();
  }
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  std::thread thread_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "oven");
  Oven oven;
  ros::spin();
}
