// Several spinners for one queue, and threads whose number nobody wrote.
//
// expect: Count = count : { queue_served(C, Queue, Threads) }, Count = 4
// expect: Count = count : { queue_served(C, "", "1") }, Count = 2
// expect: queue_served(_, Queue, "0"), variable_name(as(Queue, Variable), "default_queue")
// expect: queue_served(_, Queue, "3"), variable_name(as(Queue, Variable), "counted_queue")
// expect: Count = count : { queue_concurrent(Queue) }, Count = 3
// expect: queue_concurrent("")
// expect: Count = count : { concurrent_callbacks(F, G) }, Count = 3
// expect: concurrent_callbacks(F, F), function_name(F, "onShared")
// expect: concurrent_callbacks(F, G), function_name(F, "onIn"), function_name(G, "onShared")
// expect-not: concurrent_callbacks(F, F), function_name(F, "onIn")
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <std_msgs/Empty.h>

enum
{
  kThreads = 3
};

void onIn(const std_msgs::Empty&) {}
void onShared(const std_msgs::Empty&) {}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  ros::CallbackQueue default_queue, counted_queue;
  ros::Subscriber sub = nh.subscribe("/in", 1, onIn);
  ros::Subscriber left_sub = nh.subscribe("/left", 1, onShared);
  ros::Subscriber right_sub = nh.subscribe("/right", 1, onShared);
  ros::AsyncSpinner spinner(1);
  spinner.start();
  ros::AsyncSpinner default_spinner(0, &default_queue);
  ros::AsyncSpinner counted_spinner(kThreads, &counted_queue);
  ros::spin();
}
