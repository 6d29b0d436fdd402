// A function that runs what it is given runs for each caller what that gave, not what others did: the lock around a value. Where something decides whether it runs, all that it may
// be given are thought of.
//
// expect: reactive left -> left_seen must
// expect: reactive right -> right_seen must
// expect: reactive right -> half_seen may
// expect: reactive up -> left_seen must
// expect-only: reactive * -> *
// expect: state Node::count_
// expect: transition Node::count_ on left
// expect-only: transition Node::count_
#include <mutex>
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_msgs/Int32.h>
#include <utility>

class Guarded
{
public:
  template <typename F> auto with(F&& function)
  {
    std::lock_guard<std::mutex> lock(mutex_);
    return std::forward<F>(function)(value_);
  }

private:
  std::mutex mutex_;
  int value_ = 0;
};

template <typename F> void sometimes(int value, F function)
{
  if (value > 3)
    function();
}

class Node
{
public:
  Node()
  {
    left_seen_ = nh_.advertise<std_msgs::Int32>("left_seen", 1);
    right_seen_ = nh_.advertise<std_msgs::Bool>("right_seen", 1);
    half_seen_ = nh_.advertise<std_msgs::Bool>("half_seen", 1);
    left_ = nh_.subscribe("left", 1, &Node::onLeft, this);
    right_ = nh_.subscribe("right", 1, &Node::onRight, this);
    up_ = nh_.subscribe("up", 1, &Node::onUp, this);
  }

private:
  void onLeft(const std_msgs::Int32& message)
  {
    guarded_.with([&](int& value) {
      count_ += value;
      left_seen_.publish(message);
    });
  }

  void onRight(const std_msgs::Bool& message)
  {
    guarded_.with([&](int&) { right_seen_.publish(message); });
    if (count_ > 0)
      sometimes(count_, [&] { half_seen_.publish(message); });
  }

  void onUp(const std_msgs::Int32& message)
  {
    const int twice = guarded_.with([&](int& value) {
      left_seen_.publish(message);
      return 2 * value;
    });
  }

  ros::NodeHandle nh_;
  Guarded guarded_;
  int count_ = 0;
  ros::Publisher left_seen_, right_seen_, half_seen_;
  ros::Subscriber left_, right_, up_;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  Node node;
  ros::spin();
}
