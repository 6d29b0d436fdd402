// A number that counts by itself takes few values, whatever arrives: which ones decides what its readers do. One that is calculated of a
// message may take any.
// expect: sends_constants([_, "publisher", "gear"])
// expect: sends_constants([_, "publisher", "count"])
// expect-not: sends_constants([_, "publisher", "speed"])
// expect-not: sends_constants([_, "publisher", "sum"])
#include <ros/ros.h>
#include <std_msgs/UInt8.h>
#include <std_msgs/Empty.h>

class Shift {
public:
  Shift() {
    gear_pub_ = nh_.advertise<std_msgs::UInt8>("gear", 1);
    count_pub_ = nh_.advertise<std_msgs::UInt8>("count", 1);
    speed_pub_ = nh_.advertise<std_msgs::UInt8>("speed", 1);
    sum_pub_ = nh_.advertise<std_msgs::UInt8>("sum", 1);
    up_ = nh_.subscribe("up", 1, &Shift::onUp, this);
    to_ = nh_.subscribe("to", 1, &Shift::onSpeed, this);
  }

  void onUp(const std_msgs::Empty &) {
    gear_ = (gear_ + 1) % 3;
    ++count_;
    std_msgs::UInt8 gear, count;
    gear.data = gear_;
    count.data = count_;
    gear_pub_.publish(gear);
    count_pub_.publish(count);
  }

  void onSpeed(const std_msgs::UInt8 & wanted) {
    speed_ = wanted.data * 2;
    sum_ += wanted.data;
    std_msgs::UInt8 speed, sum;
    speed.data = speed_;
    sum.data = sum_;
    speed_pub_.publish(speed);
    sum_pub_.publish(sum);
  }

private:
  ros::NodeHandle nh_;
  ros::Publisher gear_pub_, count_pub_, speed_pub_, sum_pub_;
  ros::Subscriber up_, to_;
  int gear_ = 0, count_ = 0, speed_ = 0, sum_ = 0;
};

int main(int argc, char ** argv) {
  ros::init(argc, argv, "shift");
  Shift shift;
  ros::spin();
}
