// A class of a library that makes ports inside, whose source is in the workspace: that tells which these are.
//
// expect: service_server controller_manager/reload
// expect-not: service_server */list_controllers
#include <ros/ros.h>
#include <std_srvs/Empty.h>

namespace controller_manager
{
class ControllerManager
{
public:
  explicit ControllerManager(ros::NodeHandle handle) : handle_(handle, "controller_manager")
  {
    reload_srv_ = handle_.advertiseService("reload", &ControllerManager::reload, this);
  }

private:
  bool reload(std_srvs::Empty::Request&, std_srvs::Empty::Response&) { return true; }

  ros::NodeHandle handle_;
  ros::ServiceServer reload_srv_;
};
}  // namespace controller_manager

int main(int argc, char** argv)
{
  ros::init(argc, argv, "arm");
  controller_manager::ControllerManager manager{ros::NodeHandle()};
  ros::spin();
}
