// What a thread sends that a callback starts: in answer, but for a timed loop that goes on for ever.
//
// expect: reactive /go -> /once
// expect: reactive /go -> /until_done
// expect: periodic /until_done 10 Hz
// expect: periodic /for_ever 5 Hz
// expect: periodic /deep 2 Hz
// expect: reactive /do -> /itself
// expect: periodic /itself 4 Hz
// expect-only: reactive
// expect-only: periodic
#include <boost/thread.hpp>
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <thread>

class Worker
{
public:
  explicit Worker(ros::NodeHandle nh)
  {
    once_pub_ = nh.advertise<std_msgs::Empty>("/once", 1);
    until_pub_ = nh.advertise<std_msgs::Empty>("/until_done", 1);
    ever_pub_ = nh.advertise<std_msgs::Empty>("/for_ever", 1);
    deep_pub_ = nh.advertise<std_msgs::Empty>("/deep", 1);
    itself_pub_ = nh.advertise<std_msgs::Empty>("/itself", 1);
    go_sub_ = nh.subscribe("/go", 1, &Worker::onGo, this);
    do_sub_ = nh.subscribe("/do", 1, &Worker::onDo, this);
  }

  ~Worker() { stop_ = true; }

private:
  void onGo(const std_msgs::Empty&)
  {
    std::thread(&Worker::once, this).detach();
    std::thread(&Worker::untilDone, this).detach();
    thread_ = new boost::thread(boost::bind(&Worker::forEver, this, 5.0));
    std::thread([this]() { deep(); }).detach();
  }

  void onDo(const std_msgs::Empty&) { work(); }

  void once() { once_pub_.publish(std_msgs::Empty()); }

  void untilDone()
  {
    ros::Rate rate(10);
    for (int i = 0; ros::ok(); i++)
    {
      if (i == 3)
        return;
      until_pub_.publish(std_msgs::Empty());
      rate.sleep();
    }
  }

  void forEver(double hz)
  {
    ros::Rate rate(hz);
    while (ros::ok() && !stop_)
    {
      ever_pub_.publish(std_msgs::Empty());
      rate.sleep();
    }
  }

  void deep()
  {
    ros::Rate rate(2);
    while (ros::ok())
    {
      deep_pub_.publish(std_msgs::Empty());
      rate.sleep();
    }
  }

  void work()
  {
    ros::Rate rate(4);
    while (ros::ok())
    {
      itself_pub_.publish(std_msgs::Empty());
      rate.sleep();
    }
  }

  ros::Publisher once_pub_, until_pub_, ever_pub_, deep_pub_, itself_pub_;
  ros::Subscriber go_sub_, do_sub_;
  boost::thread* thread_ = nullptr;
  bool stop_ = false;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "worker");
  ros::NodeHandle nh;
  Worker worker(nh);
  ros::spin();
}
