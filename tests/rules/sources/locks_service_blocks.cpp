// A callback that calls the component's own service waits for itself, unless the two are served apart.
//
// expect: Count = count : { call_blocks(_, _, _) }, Count = 1
// expect: call_blocks([_, "service_client", "/reset"], [_, "service_server", "/reset"], C), expr_function(C, F), function_name(F, "onIn")
// expect: 10 = count : { evaluable(_) }
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <std_srvs/Empty.h>

ros::ServiceClient g_client;

void onIn(const std_msgs::Empty&)
{
  std_srvs::Empty request;
  g_client.call(request);
}

bool onReset(std_srvs::Empty::Request&, std_srvs::Empty::Response&)
{
  return true;
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  g_client = nh.serviceClient<std_srvs::Empty>("/reset");
  ros::ServiceServer server = nh.advertiseService("/reset", onReset);
  ros::Subscriber sub = nh.subscribe("/in", 1, onIn);
  ros::spin();
}
