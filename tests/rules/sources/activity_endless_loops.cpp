// Loops that go on as long as the node lives, each in a thread, and one that does not.
//
// expect: Count = count : { endless_loop(H) }, Count = 8
// expect: periodic /forever 1 Hz
// expect: periodic /flag 2 Hz
// expect: periodic /stopped 4 Hz
// expect: periodic /running 5 Hz
// expect: periodic /atomic 8 Hz
// expect: periodic /closing 10 Hz
// expect: periodic /both 20 Hz
// expect-only: periodic
// expect: activity(F, "thread"), function_name(F, "Node::forever")
// expect: activity(F, "end"), function_name(F, "Node::~Node")
// expect: 1 = count : { sends_in_burst(_, _, _) }
#include <atomic>
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <thread>
#include <unistd.h>

class Node
{
public:
  Node()
  {
    forever_pub_ = nh_.advertise<std_msgs::Empty>("/forever", 1);
    flag_pub_ = nh_.advertise<std_msgs::Empty>("/flag", 1);
    stopped_pub_ = nh_.advertise<std_msgs::Empty>("/stopped", 1);
    running_pub_ = nh_.advertise<std_msgs::Empty>("/running", 1);
    atomic_pub_ = nh_.advertise<std_msgs::Empty>("/atomic", 1);
    closing_pub_ = nh_.advertise<std_msgs::Empty>("/closing", 1);
    both_pub_ = nh_.advertise<std_msgs::Empty>("/both", 1);
    once_pub_ = nh_.advertise<std_msgs::Empty>("/once", 1);
    outer_pub_ = nh_.advertise<std_msgs::Empty>("/outer", 1);
    threads_[0] = std::thread(&Node::forever, this);
    threads_[1] = std::thread(&Node::flag, this);
    threads_[2] = std::thread(&Node::stopped, this);
    threads_[3] = std::thread(&Node::running, this);
    threads_[4] = std::thread(&Node::atomic, this);
    threads_[5] = std::thread(&Node::closing, this);
    threads_[6] = std::thread(&Node::both, this);
  }

  ~Node()
  {
    stopped_ = true;
    running_ = false;
  }

private:
  void forever()
  {
    for (;;)
    {
      forever_pub_.publish(std_msgs::Empty());
      ros::Duration(1.0).sleep();
    }
  }

  void flag()
  {
    while (flag_)
    {
      flag_pub_.publish(std_msgs::Empty());
      pause();
    }
  }

  void pause()
  {
    ros::Duration(0.5).sleep();
  }

  void stopped()
  {
    ros::Rate rate(4);
    while (!stopped_)
    {
      stopped_pub_.publish(std_msgs::Empty());
      rate.sleep();
    }
  }

  void running()
  {
    ros::Rate rate(5);
    while (ros::ok() && running_)
    {
      running_pub_.publish(std_msgs::Empty());
      rate.sleep();
    }
    once_pub_.publish(std_msgs::Empty());
  }

  void atomic()
  {
    ros::Rate rate(8);
    while (atomic_)
    {
      atomic_pub_.publish(std_msgs::Empty());
      rate.sleep();
    }
  }

  void closing()
  {
    ros::Rate rate(10);
    while (!ros::isShuttingDown())
    {
      closing_pub_.publish(std_msgs::Empty());
      rate.sleep();
    }
  }

  void both()
  {
    ros::Rate rate(20);
    while (ros::ok())
    {
      outer_pub_.publish(std_msgs::Empty());
      while (ros::ok() && running_ && flag_)
      {
        both_pub_.publish(std_msgs::Empty());
        rate.sleep();
      }
    }
  }

  ros::NodeHandle nh_;
  ros::Publisher forever_pub_, flag_pub_, stopped_pub_, running_pub_, atomic_pub_, closing_pub_, both_pub_, once_pub_, outer_pub_;
  volatile bool flag_ = true;
  bool stopped_ = false;
  volatile int running_ = 1;
  std::atomic<bool> atomic_{true};
  std::thread threads_[7];
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  Node node;
  ros::spin();
}
