// Queues and the threads that serve them: which callbacks may run at once.
//
// expect: Count = count : { queue_served(C, Queue, Threads) }, Count = 5
// expect: queue_served(_, "", "2")
// expect: queue_served(_, Queue, "1"), variable_name(as(Queue, Variable), "own_queue")
// expect: queue_served(_, Queue, "0"), variable_name(as(Queue, Variable), "all_queue")
// expect: queue_served(_, Queue, "?"), variable_name(as(Queue, Variable), "some_queue")
// expect: queue_concurrent("")
// expect: Count = count : { queue_concurrent(Queue) }, Count = 3
// expect: concurrent_callbacks(F, G), function_name(F, "onGlobal"), function_name(G, "onOther")
// expect: concurrent_callbacks(F, G), function_name(F, "onOwn"), function_name(G, "onGlobal")
// expect: concurrent_callbacks(F, G), function_name(F, "onGlobal"), function_name(G, "onOwn")
// expect: Count = count : { concurrent_callbacks(F, G) }, Count = 14
// expect: Count = count : { callback_queue(Site, Queue) }, Count = 3
// expect-not: concurrent_callbacks(F, G), function_name(F, "onOwn"), function_name(G, "onThird")
// expect-not: concurrent_callbacks(F, G), function_name(F, "onOwn"), function_name(G, "onOwnToo")
// expect: 3 = count : { as_given(_, _, _) }
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <std_msgs/Empty.h>

void onGlobal(const std_msgs::Empty&)
{
}

void onOther(const std_msgs::Empty&)
{
}

void onOwn(const std_msgs::Empty&)
{
}

void onOwnToo(const std_msgs::Empty&)
{
}

void onThird(const std_msgs::Empty&)
{
}

// nobody calls it
void unused(ros::CallbackQueue& queue)
{
  ros::AsyncSpinner spinner(4);
  queue.callAvailable();
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh, own_nh, third_nh;
  ros::CallbackQueue own_queue, all_queue, some_queue, third_queue;
  own_nh.setCallbackQueue(&own_queue);
  ros::Subscriber global_sub = nh.subscribe("/global", 1, onGlobal);
  ros::Subscriber other_sub = nh.subscribe("/other", 1, onOther);
  ros::Subscriber own_sub = own_nh.subscribe("/own", 1, onOwn);
  ros::Subscriber own_too_sub = own_nh.subscribe("/own_too", 1, onOwnToo);
  third_nh.setCallbackQueue(&third_queue);
  int rate;
  own_nh.getParam("rate", rate);
  ros::Publisher pub = own_nh.advertise<std_msgs::Empty>("/out", 1);
  ros::Subscriber third_sub = third_nh.subscribe("/third", 1, onThird);
  ros::AsyncSpinner spinner(2);
  spinner.start();
  ros::AsyncSpinner all_spinner(0, &all_queue);
  ros::AsyncSpinner some_spinner(argc, &some_queue);
  while (ros::ok())
  {
    own_queue.callAvailable(ros::WallDuration(0.1));
    third_queue.callAvailable();
  }
}
