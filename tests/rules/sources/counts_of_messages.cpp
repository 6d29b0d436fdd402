// How many messages a callback, or a round of a loop, sends at most.
//
// expect: answers_most([_, _, "/in"], [_, _, "/once"], "1")
// expect: answers_most([_, _, "/in"], [_, _, "/twice"], "2")
// expect: answers_most([_, _, "/in"], [_, _, "/either"], "1")
// expect: answers_most([_, _, "/in"], [_, _, "/one_more"], "2")
// expect: answers_most([_, _, "/in"], [_, _, "/or_return"], "1")
// expect: answers_most([_, _, "/in"], [_, _, "/looped"], "many")
// expect: answers_most([_, _, "/in"], [_, _, "/done"], "many")
// expect: answers_most([_, _, "/in"], [_, _, "/entered_twice"], "4")
// expect: answers_most([_, _, "/in"], [_, _, "/entered_in_loop"], "many")
// expect: answers_most([_, _, "/in"], [_, _, "/paused"], "2")
// expect: answers_most([_, _, "/in"], [_, _, "/handled"], "1")
// expect: Count = count : { answers_most(_, _, _) }, Count = 11
// expect: round_sends(_, [_, _, "/timed"], "2")
// expect: round_sends(_, [_, _, "/round"], "3")
// expect: Count = count : { round_sends(_, _, _) }, Count = 2
// expect: sends_in_burst(_, [_, _, "/twice"], "2")
// expect: sends_in_burst(_, [_, _, "/one_more"], "2")
// expect: sends_in_burst(_, [_, _, "/looped"], "many")
// expect: sends_in_burst(_, [_, _, "/timed"], "2")
// expect: sends_in_burst(_, [_, _, "/round"], "3")
// expect-not: sends_in_burst(_, [_, _, "/once"], _)
// expect-not: sends_in_burst(_, [_, _, "/either"], _)
// expect-not: sends_in_burst(_, [_, _, "/paused"], _)
// expect-not: sends_in_burst(_, [_, _, "/main"], _)
// expect-not: sends_in_burst(_, [_, _, "/thread"], _)
// expect: sent_untimed([_, _, "/thread"])
// expect: Count = count : { sent_untimed(_) }, Count = 1
// expect: sent_otherwise([_, _, "/thread"])
// expect: sent_otherwise([_, _, "/main"])
// expect: sent_otherwise([_, _, "/given"])
// expect: Count = count : { sent_otherwise(_) }, Count = 3
#include <ros/ros.h>
#include <stdexcept>
#include <std_msgs/Int32.h>
#include <thread>

ros::Publisher once_pub, twice_pub, either_pub, one_more_pub, or_return_pub, looped_pub, done_pub, entered_twice_pub, entered_in_loop_pub, paused_pub, handled_pub;
ros::Publisher timed_pub, round_pub, main_pub, thread_pub, given_pub;

void keep(const ros::Publisher& publisher);

void sendTwo(const std_msgs::Int32& message)
{
  entered_twice_pub.publish(message);
  entered_twice_pub.publish(message);
}

void sendOne(const std_msgs::Int32& message)
{
  entered_in_loop_pub.publish(message);
}

void onIn(const std_msgs::Int32& message)
{
  once_pub.publish(message);
  twice_pub.publish(message);
  twice_pub.publish(message);
  if (message.data > 0)
    either_pub.publish(message);
  else
    either_pub.publish(message);
  if (message.data > 1)
    one_more_pub.publish(message);
  one_more_pub.publish(message);
  for (int i = 0; i < message.data; ++i)
    looped_pub.publish(message);
  int left = message.data;
  do
  {
    done_pub.publish(message);
  } while (--left > 0);
  sendTwo(message);
  sendTwo(message);
  for (int i = 0; i < message.data; ++i)
    sendOne(message);
  if (message.data > 2)
  {
    or_return_pub.publish(message);
    return;
  }
  or_return_pub.publish(message);
}

void onPaused(const std_msgs::Int32& message)
{
  paused_pub.publish(message);
  ros::Duration(0.1).sleep();
  paused_pub.publish(message);
}

void onHandled(const std_msgs::Int32& message)
{
  try
  {
    handled_pub.publish(message);
  }
  catch (const std::runtime_error&)
  {
    handled_pub.publish(message);
  }
}

void onTimer(const ros::TimerEvent&)
{
  timed_pub.publish(std_msgs::Int32());
  timed_pub.publish(std_msgs::Int32());
}

void run()
{
  thread_pub.publish(std_msgs::Int32());
  thread_pub.publish(std_msgs::Int32());
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "counts");
  ros::NodeHandle nh;
  once_pub = nh.advertise<std_msgs::Int32>("/once", 1);
  twice_pub = nh.advertise<std_msgs::Int32>("/twice", 1);
  either_pub = nh.advertise<std_msgs::Int32>("/either", 1);
  one_more_pub = nh.advertise<std_msgs::Int32>("/one_more", 1);
  or_return_pub = nh.advertise<std_msgs::Int32>("/or_return", 1);
  looped_pub = nh.advertise<std_msgs::Int32>("/looped", 1);
  done_pub = nh.advertise<std_msgs::Int32>("/done", 1);
  entered_twice_pub = nh.advertise<std_msgs::Int32>("/entered_twice", 1);
  entered_in_loop_pub = nh.advertise<std_msgs::Int32>("/entered_in_loop", 1);
  paused_pub = nh.advertise<std_msgs::Int32>("/paused", 1);
  handled_pub = nh.advertise<std_msgs::Int32>("/handled", 1);
  timed_pub = nh.advertise<std_msgs::Int32>("/timed", 1);
  round_pub = nh.advertise<std_msgs::Int32>("/round", 1);
  main_pub = nh.advertise<std_msgs::Int32>("/main", 1);
  thread_pub = nh.advertise<std_msgs::Int32>("/thread", 1);
  given_pub = nh.advertise<std_msgs::Int32>("/given", 1);
  keep(given_pub);
  ros::Subscriber sub = nh.subscribe("/in", 1, onIn), paused = nh.subscribe("/in", 1, onPaused), handled = nh.subscribe("/in", 1, onHandled);
  ros::Timer timer = nh.createTimer(ros::Duration(1.0), onTimer);
  std::thread thread(run);
  main_pub.publish(std_msgs::Int32());
  main_pub.publish(std_msgs::Int32());
  ros::Rate rate(10);
  while (ros::ok())
  {
    round_pub.publish(std_msgs::Int32());
    round_pub.publish(std_msgs::Int32());
    round_pub.publish(std_msgs::Int32());
    ros::spinOnce();
    rate.sleep();
  }
}
