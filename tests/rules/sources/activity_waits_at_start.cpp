// A loop that waits for something at the start is not where the main activity begins.
//
// expect: Count = count : { activity(Root, "loop") }, Count = 3
// expect: periodic /out 5 Hz
// expect: state g_arrived = false
// expect: state g_step
// expect: transition g_arrived = true on /in
// expect: transition g_step = 5 on periodic
// expect-only: transition
// expect: Count = count : { _main_loop(H) }, Count = 1
// expect: N = count : { _done_before(_, _) }, N = 2
// expect-not: _comparison(_, _, _, _)
// expect: 15 = count : { control_dependence(_, _, _, _) }
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <unistd.h>

ros::Publisher g_pub;
ros::ServiceClient g_client;
bool g_arrived = false;
int g_step = 0;

void onIn(const std_msgs::Empty&)
{
  g_arrived = true;
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  g_pub = nh.advertise<std_msgs::Empty>("/out", 1);
  ros::Subscriber sub = nh.subscribe("/in", 1, onIn);
  while (true)
  {
    if (argc > 1)
      break;
  }
  g_step = 1;
  for (;;)
  {
    if (ros::service::exists("/reset", false))
      break;
    usleep(1000);
  }
  g_step = 2;
  while (!g_arrived)
  {
    if (argc > 2)
      break;
  }
  g_step = 3;
  while (ros::ok() && !g_arrived)
    usleep(1000);
  g_step = 4;
  ros::Rate rate(5);
  while (ros::ok())
  {
    if (g_arrived && g_step > 3)
      g_pub.publish(std_msgs::Empty());
    g_step = 5;
    ros::spinOnce();
    rate.sleep();
  }
}
