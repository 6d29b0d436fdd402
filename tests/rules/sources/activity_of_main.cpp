// What main does before its first wait is the beginning, what it does from then on is an activity; timed loops are activities of their own.
//
// expect: publisher /out std_msgs/Int32
// expect: publisher /done std_msgs/Int32
// expect: subscriber /in
// expect: reactive /in -> /out may if "g_phase == 3"
// expect: periodic /out 10 Hz mechanism=rate conditional="g_phase > 4"
// expect: state g_phase
// expect: state g_running = true
// expect: transition g_running = false on /in if "message.data < 0"
// expect: transition g_phase = 5 on periodic
// expect: transition g_phase = 6 on main
// expect: transition g_phase = 7 on main
// expect: transition g_phase = 8 on main
// expect: transition g_phase = message.data on /in
// expect-only: *
// expect: Count = count : { activity(Root, Kind) }, Count = 3
// expect: activity(F, "main"), function_name(F, "main")
// expect: Count = count : { activity_enters(Root, F) }, Count = 2
// expect: activity_enters(Root, F), function_name(F, "step"), activity(Root, "loop")
// expect: activity_enters(Root, F), function_name(F, "finish"), activity(Root, "main")
// expect: Count = count : { activity_expr(Root, E), activity(Root, "main") }, Count = 6
// expect: Count = count : { activity_expr(Root, E), activity(Root, "loop") }, Count = 3
// expect: Count = count : { activity_expr(Root, E), activity(Root, "callback") }, Count = 3
// expect: Count = count : { _main_stack(F) }, Count = 2
// expect-not: reachable(F), function_name(F, "rehearse")
// expect: N = count : { _sending_block(_) }, N = 6
// expect-not: ends_loops(_)
#include <ros/ros.h>
#include <std_msgs/Int32.h>

ros::Publisher g_pub, g_done_pub;
int g_phase = 0;
bool g_running = true;

void onIn(const std_msgs::Int32& message)
{
  if (message.data < 0)
    g_running = false;
  if (g_phase == 3)
    g_pub.publish(message);
  g_phase = message.data;
}

void prepare()
{
  g_phase = 4;
}

void step()
{
  g_phase = 5;
  if (g_phase > 4)
    g_pub.publish(std_msgs::Int32());
}

void finish()
{
  g_phase = 8;
  g_done_pub.publish(std_msgs::Int32());
}

void serve()
{
  g_phase = 3;
  prepare();
  ros::Rate rate(10);
  while (ros::ok() && g_running)
  {
    step();
    ros::spinOnce();
    rate.sleep();
  }
  g_phase = 6;
  finish();
}

// nobody calls it
void rehearse()
{
  ros::Rate rate(50);
  while (ros::ok())
  {
    step();
    rate.sleep();
  }
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  g_pub = nh.advertise<std_msgs::Int32>("/out", 1);
  g_done_pub = nh.advertise<std_msgs::Int32>("/done", 1);
  ros::Subscriber sub = nh.subscribe("/in", 1, onIn);
  g_phase = 1;
  while (ros::ok() && !ros::master::check())
    g_phase = 2;
  serve();
  g_phase = 7;
}
