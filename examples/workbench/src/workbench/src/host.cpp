#include "tool.h"

#include <memory>
#include <string>

#include <controller_manager/controller_manager.h>
#include <hardware_interface/robot_hw.h>
#include <interactive_markers/interactive_marker_server.h>
#include <nodelet/loader.h>
#include <pcl_ros/publisher.h>
#include <pluginlib/class_loader.h>
#include <realtime_tools/realtime_publisher.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <std_msgs/Float64.h>

class Host
{
public:
  Host()
    : private_nh_("~")
    , tools_("workbench", "workbench::Tool")
    , markers_("parts")
    , controllers_(&robot_, nh_)
    , load_(new realtime_tools::RealtimePublisher<std_msgs::Float64>(private_nh_, "load", 4, true))
  {
    std::string tool;
    private_nh_.param<std::string>("tool", tool, "workbench/Drill");
    tool_ = tools_.createInstance(tool);
    tool_->initialize(nh_);

    ros::M_string remappings;
    remappings["parts"] = "/conveyor/parts";
    nodelets_.load(ros::this_node::getName() + "/counter", "workbench/Counter", remappings, std::vector<std::string>());

    cloud_.advertise(nh_, "surface", 2);
    realtime_nh_.setCallbackQueue(&queue_);
    stop_ = realtime_nh_.subscribe("stop", 1, &Host::onStop, this);
    spinner_.reset(new ros::AsyncSpinner(1, &queue_));
    spinner_->start();
  }

private:
  void onStop(const std_msgs::Float64&)
  {
  }

  ros::NodeHandle nh_, private_nh_, realtime_nh_;
  ros::CallbackQueue queue_;
  std::unique_ptr<ros::AsyncSpinner> spinner_;
  hardware_interface::RobotHW robot_;
  pluginlib::ClassLoader<workbench::Tool> tools_;
  boost::shared_ptr<workbench::Tool> tool_;
  nodelet::Loader nodelets_;
  interactive_markers::InteractiveMarkerServer markers_;
  controller_manager::ControllerManager controllers_;
  std::unique_ptr<realtime_tools::RealtimePublisher<std_msgs::Float64>> load_;
  pcl_ros::Publisher<pcl::PointXYZ> cloud_;
  ros::Subscriber stop_;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "workbench");
  Host host;
  ros::spin();
  return 0;
}
