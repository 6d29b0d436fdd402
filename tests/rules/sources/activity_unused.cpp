// What nobody calls does nothing, whatever it would do.
//
// expect: component activity_unused node_name=used
// expect: publisher /out
// expect: subscriber /in
// expect: subscriber /tf_static
// expect: service_client /service
// expect: tf_broadcaster
// expect: tf_listener
// expect: reactive /in -> /out if "g_mode == 1"
// expect: state g_mode = 0
// expect: transition g_mode = 1 on /in
// expect-only: *
// expect: Count = count : { activity(F, Kind) }, Count = 2
// expect-not: sleep(_, _)
// expect-not: sets_off(_)
// expect-not: frame_lookup(_, _, _)
// expect-not: frame_broadcast(_, _, _)
// expect-not: waits_for(_, _)
// expect-not: called(F), function_name(F, "neverCalled")
// expect-not: gets_anything(_)
// expect-not: lasting_class("NeverMade")
// expect-not: gives_constant(_, _, _, "7")
// expect-not: _lookup_argument(_, _, _); _sent(_, _); _first_value(_, _)
#include <csignal>
#include <memory>
#include <ros/ros.h>
#include <std_msgs/Int32.h>
#include <std_srvs/Empty.h>
#include <tf/transform_broadcaster.h>
#include <tf/transform_listener.h>

ros::Publisher g_pub;
ros::ServiceClient g_client;
ros::Timer g_timer;
tf::TransformBroadcaster* g_broadcaster;
tf::TransformListener* g_listener;
int g_mode = 0;

struct NeverMade
{
  ~NeverMade()
  {
    g_mode = 4;
  }
};

void neverCalled()
{
  g_mode = 5;
}

void neverATimer(const ros::TimerEvent&)
{
  g_pub.publish(std_msgs::Int32());
}

void neverASignal(int)
{
  g_mode = 6;
}

void onIn(const std_msgs::Int32& message)
{
  if (g_mode == 1)
    g_pub.publish(message);
  g_mode = 1;
}

void unused(ros::NodeHandle& nh, int number)
{
  signal(SIGINT, neverASignal);
  g_timer = nh.createTimer(ros::Duration(1.0), neverATimer);
  g_timer.start();
  g_client.waitForExistence();
  tf::StampedTransform transform;
  g_listener->lookupTransform("never", "ever", ros::Time(0), transform);
  g_broadcaster->sendTransform(tf::StampedTransform(transform, ros::Time(0), "never", "ever"));
  std::unique_ptr<NeverMade> made(new NeverMade);
  neverCalled();
  g_mode = number;
  g_mode = 7;
  ros::Rate rate(10);
  while (ros::ok())
  {
    g_pub.publish(std_msgs::Int32());
    rate.sleep();
  }
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "used");
  ros::NodeHandle nh;
  g_pub = nh.advertise<std_msgs::Int32>("/out", 1);
  g_client = nh.serviceClient<std_srvs::Empty>("/service");
  g_broadcaster = new tf::TransformBroadcaster;
  g_listener = new tf::TransformListener;
  ros::Subscriber sub = nh.subscribe("/in", 1, onIn);
  ros::spin();
}
