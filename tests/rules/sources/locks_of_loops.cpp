// A loop of main beside callbacks that a spinner's threads run: what both change, with locks and without.
//
// expect: Count = count : { changed_at_once(V, E, D) }, Count = 4
// expect: Count = count : { changed_at_once(V, E, D), variable_name(V, "g_count") }, Count = 2
// expect: Count = count : { changed_at_once(V, E, D), variable_name(V, "g_added") }, Count = 2
// expect-not: changed_at_once(V, _, _), variable_name(V, "g_guarded")
// expect-not: changed_at_once(V, _, _), variable_name(V, "g_same")
// expect-not: changed_at_once(V, _, _), variable_name(V, "g_stop")
// expect: Count = count : { concurrent(F, G) }, Count = 8
// expect: concurrent(F, G), function_name(as(F, Function), "onIn"), activity(G, "loop")
// expect: concurrent(F, G), activity(F, "loop"), function_name(as(G, Function), "onIn")
// expect: concurrent(F, G), function_name(as(F, Function), "onIn"), activity(G, "main")
// expect-not: concurrent(_, F), activity(F, "signal")
// expect: Count = count : { locks(F) }, Count = 1
// expect: locks(F), function_name(F, "onGuarded")
// expect-not: serves_callbacks(_)
#include <csignal>
#include <mutex>
#include <ros/ros.h>
#include <std_msgs/Int32.h>

std::mutex g_mutex;
std::unique_lock<std::mutex> g_global_lock;
ros::Publisher g_pub;
int g_count = 0, g_added = 0, g_guarded = 0;
bool g_same = false, g_stop = false;

void onIn(const std_msgs::Int32& message)
{
  g_count = message.data;
  g_added += 1;
  g_same = true;
  if (g_count > 1 && g_added > 1 && g_same)
    g_pub.publish(message);
}

void onGuarded(const std_msgs::Int32& message)
{
  std::lock_guard<std::mutex> guard(g_mutex);
  g_guarded = message.data;
  if (g_guarded > 1)
    g_pub.publish(message);
}

void onSignal(int)
{
  g_stop = true;
}

void step()
{
  g_count = 0;
  g_added += 1;
  g_same = true;
}

void run()
{
  ros::Rate rate(10);
  while (ros::ok() && !g_stop)
  {
    step();
    rate.sleep();
  }
}

// nobody calls it
void lockedStep()
{
  g_mutex.lock();
  g_guarded = 0;
  g_mutex.unlock();
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  g_pub = nh.advertise<std_msgs::Int32>("/out", 1);
  ros::Subscriber sub = nh.subscribe("/in", 1, onIn);
  ros::Subscriber guarded_sub = nh.subscribe("/guarded", 1, onGuarded);
  signal(SIGINT, onSignal);
  ros::AsyncSpinner spinner(1);
  spinner.start();
  run();
}
