// A client of a reconfigurable node reads what that tells, and asks it to change: at the name of the server, not its own.
//
// expect: subscriber /planner/parameter_updates dynamic_reconfigure/Config implicit
// expect: subscriber /planner/parameter_descriptions dynamic_reconfigure/ConfigDescription implicit
// expect: service_client /planner/set_parameters dynamic_reconfigure/Reconfigure implicit
// expect: service_client gripper/set_parameters dynamic_reconfigure/Reconfigure implicit
// expect: Count = count : { implicit_port(_, _) }, Count = 6
#include <dynamic_reconfigure/client.h>
#include <ros/ros.h>

struct Config
{
  double speed;
};

dynamic_reconfigure::Client<Config>* g_planner;

void onConfig(const Config& config) {}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "tuner");
  ros::NodeHandle nh;
  g_planner = new dynamic_reconfigure::Client<Config>("/planner", onConfig);
  dynamic_reconfigure::Client<Config> gripper("gripper", nh);
  ros::spin();
}
