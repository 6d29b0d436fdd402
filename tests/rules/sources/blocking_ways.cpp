// Calls and loops that wait without a limit for somebody else, and what is only provided after them.
//
// expect: waits_for(_, [_, "service_client", "/existence"])
// expect: waits_for(_, [_, "service_client", "/endless"])
// expect: waits_for(_, [_, "service_client", "/named"])
// expect: waits_for(_, [_, "service_client", "/asked_again"])
// expect: waits_for(_, [_, "subscriber", "/message"])
// expect: waits_for(_, [_, "subscriber", "/message_with_handle"])
// expect: waits_for(_, [_, "action_client", "/action"])
// expect: waits_for(_, [_, "subscriber", "/not_ready"])
// expect: waits_for(_, [_, "subscriber", "/is_false"])
// expect: waits_for(_, [_, "subscriber", "/false_is"])
// expect: waits_for(_, [_, "subscriber", "/while_alive"])
// expect: waits_for(_, [_, "subscriber", "/either"])
// expect: waits_for(_, [_, "subscriber", "/or_this"])
// expect: waits_for(_, [_, "subscriber", "/both"])
// expect: waits_for(_, [_, "subscriber", "/and_this"])
// expect: waits_for(_, [_, "subscriber", "/left_when_dead"])
// expect: waits_for(_, [_, "subscriber", "/left_otherwise"])
// expect: waits_for(_, [_, "subscriber", "/in_function"])
// expect: waits_for(_, [_, "subscriber", "/sometimes"])
// expect: Count = count : { waits_for(_, Port) }, Count = 19
// expect-not: waits_for(_, [_, _, Name]), contains("limited", Name)
// expect-not: waits_for(_, [_, _, "/until_it_is"])
// expect-not: waits_for(_, [_, _, "/while_true"])
// expect-not: waits_for(_, [_, _, "/compared_with_another"])
//
// expect: provides_after([_, "service_server", "/late"], W), waits_for(W, [_, _, "/existence"])
// expect: provides_after([_, "action_server", "/late_action"], W), waits_for(W, [_, _, "/existence"])
// expect: provides_after([_, "publisher", "/late_message"], W), waits_for(W, [_, _, "/existence"])
// expect: provides_after([_, "publisher", "/from_function"], W), waits_for(W, [_, _, "/existence"])
// expect: provides_after([_, "service_server", "/late"], W), waits_for(W, [_, _, "/not_ready"])
// expect: provides_after([_, "service_server", "/late"], W), waits_for(W, [_, _, "/in_function"])
// expect: provides_after([_, "service_server", "/late"], W), waits_for(W, [_, _, "/left_when_dead"])
// expect-not: provides_after([_, _, "/early"], _)
// expect-not: provides_after([_, _, "/early_message"], _)
// expect-not: provides_after([_, _, "/early_too"], _)
// expect-not: provides_after([_, _, "/from_callback"], _)
// expect-not: provides_after([_, "subscriber", _], _)
// expect-not: provides_after([_, "service_client", _], _)
// expect-not: provides_after([_, _, "/late"], W), waits_for(W, [_, _, "/sometimes"])
// expect: 22 = count : { message_arrives(_, _) }, 8 = count : { value_goes(_, _, _) }
#include <actionlib/client/simple_action_client.h>
#include <actionlib/server/simple_action_server.h>
#include <actionlib_tutorials/FibonacciAction.h>
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_srvs/Empty.h>

typedef actionlib::SimpleActionServer<actionlib_tutorials::FibonacciAction> Server;
typedef actionlib::SimpleActionClient<actionlib_tutorials::FibonacciAction> Client;

bool g_not_ready = false, g_is_false = false, g_false_is = false, g_while_alive = false, g_either = false, g_or_this = false, g_both = false, g_and_this = false;
bool g_left = false, g_left_when_dead = false, g_left_otherwise = false, g_limited = false, g_in_function = false, g_sometimes = false, g_until = false, g_true = false, g_compared = false;
int g_tries = 0;
ros::Publisher g_early_pub, g_late_pub, g_function_pub, g_callback_pub;

void onNotReady(const std_msgs::Bool& message)
{
  g_not_ready = true;
  g_callback_pub.publish(message);
}

void onIsFalse(const std_msgs::Bool&) { g_is_false = true; }
void onFalseIs(const std_msgs::Bool&) { g_false_is = true; }
void onWhileAlive(const std_msgs::Bool&) { g_while_alive = true; }
void onEither(const std_msgs::Bool&) { g_either = true; }
void onOrThis(const std_msgs::Bool&) { g_or_this = true; }
void onBoth(const std_msgs::Bool&) { g_both = true; }
void onAndThis(const std_msgs::Bool&) { g_and_this = true; }
void onLeft(const std_msgs::Bool&) { g_left = true; }
void onLeftWhenDead(const std_msgs::Bool&) { g_left_when_dead = true; }
void onLeftOtherwise(const std_msgs::Bool&) { g_left_otherwise = true; }
void onUntil(const std_msgs::Bool&) { g_until = true; }
void onTrue(const std_msgs::Bool&) { g_true = true; }
void onCompared(const std_msgs::Bool&) { g_compared = true; }
void onLimited(const std_msgs::Bool&) { g_limited = true; }
void onInFunction(const std_msgs::Bool&) { g_in_function = true; }
void onSometimes(const std_msgs::Bool&) { g_sometimes = true; }

bool serve(std_srvs::Empty::Request&, std_srvs::Empty::Response&) { return true; }

void waitInFunction()
{
  while (ros::ok() && !g_in_function)
    ros::spinOnce();
}

void waitSometimes()
{
  if (g_tries > 3)
  {
    while (!g_sometimes)
      ros::spinOnce();
  }
}

void sendInFunction()
{
  g_function_pub.publish(std_msgs::Bool());
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "waiter");
  ros::NodeHandle nh;
  ros::Subscriber subs[] = {
    nh.subscribe("/not_ready", 1, onNotReady), nh.subscribe("/is_false", 1, onIsFalse), nh.subscribe("/false_is", 1, onFalseIs),
    nh.subscribe("/while_alive", 1, onWhileAlive), nh.subscribe("/either", 1, onEither), nh.subscribe("/or_this", 1, onOrThis),
    nh.subscribe("/both", 1, onBoth), nh.subscribe("/and_this", 1, onAndThis), nh.subscribe("/limited_by_break", 1, onLeft),
    nh.subscribe("/left_when_dead", 1, onLeftWhenDead), nh.subscribe("/left_otherwise", 1, onLeftOtherwise), nh.subscribe("/limited_by_tries", 1, onLimited),
    nh.subscribe("/in_function", 1, onInFunction), nh.subscribe("/sometimes", 1, onSometimes), nh.subscribe("/until_it_is", 1, onUntil), nh.subscribe("/while_true", 1, onTrue),
    nh.subscribe("/compared_with_another", 1, onCompared)};
  g_early_pub = nh.advertise<std_msgs::Bool>("/early_message", 1);
  g_late_pub = nh.advertise<std_msgs::Bool>("/late_message", 1);
  g_function_pub = nh.advertise<std_msgs::Bool>("/from_function", 1);
  g_callback_pub = nh.advertise<std_msgs::Bool>("/from_callback", 1);
  ros::ServiceServer early = nh.advertiseService("/early", serve);
  Server early_too(nh, "/early_too", false);
  g_early_pub.publish(std_msgs::Bool());

  ros::ServiceClient existence = nh.serviceClient<std_srvs::Empty>("/existence");
  existence.waitForExistence();
  ros::ServiceClient endless = nh.serviceClient<std_srvs::Empty>("/endless");
  endless.waitForExistence(ros::Duration(-1.0));
  ros::ServiceClient limited = nh.serviceClient<std_srvs::Empty>("/limited");
  limited.waitForExistence(ros::Duration(5.0));
  ros::ServiceClient named = nh.serviceClient<std_srvs::Empty>("/named");
  ros::service::waitForService("/named");
  ros::ServiceClient limited_name = nh.serviceClient<std_srvs::Empty>("/limited_name");
  ros::service::waitForService("/limited_name", ros::Duration(3.0));
  ros::ServiceClient again = nh.serviceClient<std_srvs::Empty>("/asked_again");
  while (!again.waitForExistence(ros::Duration(1.0)))
    ROS_INFO("waiting");
  ros::topic::waitForMessage<std_msgs::Bool>("/message");
  ros::topic::waitForMessage<std_msgs::Bool>("/message_with_handle", nh);
  ros::topic::waitForMessage<std_msgs::Bool>("/limited_message", nh, ros::Duration(2.0));
  Client action("/action", true);
  action.waitForServer();
  Client limited_action("/limited_action", true);
  limited_action.waitForServer(ros::Duration(4.0));

  while (!g_not_ready)
    ros::spinOnce();
  while (g_is_false == false)
    ros::spinOnce();
  while (false == g_false_is)
    ros::spinOnce();
  while (ros::ok() && !g_while_alive)
    ros::spinOnce();
  while (!g_either || !g_or_this)
    ros::spinOnce();
  while (!g_both && !g_and_this)
    ros::spinOnce();
  while (!g_left)
  {
    ros::spinOnce();
    if (++g_tries > 10)
      break;
  }
  while (!g_left_when_dead)
  {
    ros::spinOnce();
    if (!ros::ok())
      return 0;
  }
  while (!g_left_otherwise)
  {
    if (ros::ok())
      ros::spinOnce();
    else
      break;
  }
  while (g_until)
    ros::spinOnce();
  while (g_true == true)
    ros::spinOnce();
  while (g_compared == (g_tries > 5))
    ros::spinOnce();
  while (!g_limited && g_tries < 20)
    ros::spinOnce();
  waitInFunction();
  waitSometimes();

  ros::ServiceServer late = nh.advertiseService("/late", serve);
  Server late_action(nh, "/late_action", false);
  g_early_pub.publish(std_msgs::Bool());
  g_late_pub.publish(std_msgs::Bool());
  sendInFunction();
  ros::spin();
}
