#include <map>
#include <string>
#include <vector>

#include <XmlRpcValue.h>
#include <ros/ros.h>

int main(int argc, char** argv)
{
  ros::init(argc, argv, "settings");
  ros::NodeHandle nh, pnh("~");

  int window;
  double gain, limit = 0.25;
  bool verbose;
  std::string unit;
  std::vector<std::string> probes;
  std::map<std::string, double> scales;
  XmlRpc::XmlRpcValue layout;

  pnh.param("window", window, 3);
  pnh.param<double>("gain", gain, 2.5 * 2);
  unit = pnh.param<std::string>("unit", "celsius");
  const std::string label = pnh.param("label", std::string("roof"));
  verbose = nh.param("verbose", false);
  pnh.getParam("limit", limit);
  nh.getParam("/probes", probes);
  pnh.getParam("scales", scales);
  pnh.getParam("layout", layout);
  nh.getParamCached("window_now", window);

  ros::param::param("~offset", gain, -0.5);
  ros::param::get("~serial", unit);
  ros::param::getCached("/use_sim_time", verbose);
  const int retries = ros::param::param("~retries", 7);

  ros::param::set("~started", true);
  nh.setParam("probe_count", static_cast<int>(probes.size()));
  nh.setParam("state", "running");
  if (nh.hasParam("old_state") || ros::param::has("~old_state"))
  {
    nh.deleteParam("old_state");
    ros::param::del("~old_state");
  }

  std::string found;
  if (nh.searchParam("robot_name", found))
  {
    nh.getParam(found, unit);
  }

  ROS_INFO("%s: %d %d", label.c_str(), retries, window);
  ros::spin();
  return 0;
}
