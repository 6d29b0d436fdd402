// Conditions on one variable along the way: in functions that are called, on ways that meet again, and in loops.
//
// expect: reactive /in -> /certain must
// expect: reactive /in -> /real may if "!g_simulated"
// expect: reactive /in -> /simulated may if "g_simulated"
// expect: reactive /in -> /joined may if "g_simulated"
// expect: reactive /in -> /deep may if "g_simulated && message.data > 3"
// expect: reactive /in -> /changed may
// expect: reactive /other -> /never may if "message.data < 0 && !g_simulated"
// expect: reactive /other -> /deep may if "message.data < 0 && g_simulated"
// expect: reactive /other -> /certain may if "g_level > 1"
// expect: one_shot /late 1 s may if "g_simulated"
// expect-only: reactive
// expect-only: one_shot
// expect: Count = count : { contradicted(Root, E), sends(E, Port) }, Count = 3
// expect: transition g_moving = false on /in
// expect: transition g_level = 1
// expect: transition g_level = 2 on /other if "message.data < 0 && !g_simulated"
// expect-only: transition
// expect: N = count : { _enters_at(_, _) }, N = 2
// expect-not: _dropped(_, _, _); _local_made_of_parameter(_, _)
// expect: 3 = count : { flow_filter(_, _, _) }
#include <ros/ros.h>
#include <std_msgs/Int32.h>

typedef std_msgs::Int32 Message;

ros::Publisher g_certain, g_real, g_simulated_pub, g_joined, g_deep, g_never, g_changed, g_late, g_never_late, g_level_pub;
bool g_simulated = false, g_moving = false;
int g_level = 0;

void deepest(const Message& message)
{
  if (g_simulated)
  {
    g_deep.publish(message);
    g_level = 1;
  }
  else
  {
    g_never.publish(message);
    g_level = 2;
  }
}

void deeper(const Message& message)
{
  if (message.data > 3)
    deepest(message);
}

void onIn(const Message& message)
{
  if (g_simulated)
    deeper(message);
  g_certain.publish(message);
  if (g_simulated)
  {
    g_simulated_pub.publish(message);
    for (int i = 0; i < message.data; ++i)
    {
      if (g_simulated)
        continue;
      g_never.publish(message);
    }
  }
  else
    g_real.publish(message);
  if (g_simulated)
    g_joined.publish(message);

  // it is changed between
  if (!g_moving)
    return;
  g_moving = false;
  if (!g_moving)
    g_changed.publish(message);
}

// the same function, where nothing is asked before
void onOther(const Message& message)
{
  if (message.data < 0)
    deepest(message);
  if (g_level > 1)
    g_certain.publish(message);
}

void onTimeout(const ros::TimerEvent&)
{
  Message message;
  if (g_simulated)
  {
    g_late.publish(message);
    if (g_simulated)
      return;
    g_never_late.publish(message);
  }
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh, private_nh("~");
  private_nh.getParam("simulated", g_simulated);
  g_certain = nh.advertise<Message>("/certain", 1);
  g_real = nh.advertise<Message>("/real", 1);
  g_simulated_pub = nh.advertise<Message>("/simulated", 1);
  g_joined = nh.advertise<Message>("/joined", 1);
  g_deep = nh.advertise<Message>("/deep", 1);
  g_never = nh.advertise<Message>("/never", 1);
  g_changed = nh.advertise<Message>("/changed", 1);
  g_late = nh.advertise<Message>("/late", 1);
  g_never_late = nh.advertise<Message>("/never_late", 1);
  g_level_pub = nh.advertise<Message>("/level", 1);
  ros::Subscriber sub = nh.subscribe("/in", 1, onIn);
  ros::Subscriber other_sub = nh.subscribe("/other", 1, onOther);
  ros::Timer timer = nh.createTimer(ros::Duration(1.0), onTimeout, true);
  ros::spin();
}
