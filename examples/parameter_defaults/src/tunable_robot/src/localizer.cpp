#include <string>

#include <geometry_msgs/PoseStamped.h>
#include <ros/ros.h>
#include <std_msgs/String.h>

// Which source of poses is used, and where the result goes, are parameters.
class Localizer
{
public:
  Localizer() : private_nh_("~"), simulated_(false)
  {
    private_nh_.getParam("simulated", simulated_);
    std::string prefix;
    if (simulated_)
    {
      prefix = "/simulation";
      ground_truth_ = nh_.subscribe("ground_truth", 1, &Localizer::onPose, this);
    }
    estimate_ = nh_.advertise<geometry_msgs::PoseStamped>(prefix + "/estimate", 5);

    std::string source;
    private_nh_.param<std::string>("source", source, "lidar");
    std::string topic;
    if (source == "gnss")
    {
      topic = "gnss_pose";
    }
    else if (source == "lidar")
    {
      topic = "lidar_pose";
    }
    poses_ = nh_.subscribe(topic, 10, &Localizer::onPose, this);

    int level = private_nh_.param("level", 1);
    switch (level)
    {
      case 0:
        report_topic_ = "quiet";
        break;
      case 1:
        report_topic_ = "report";
        break;
      default:
        report_topic_ = "report/verbose";
    }
    makeReport();
  }

private:
  void makeReport()
  {
    report_ = nh_.advertise<std_msgs::String>(report_topic_, 1);
  }

  void onPose(const geometry_msgs::PoseStamped::ConstPtr& pose)
  {
    estimate_.publish(pose);
  }

  ros::NodeHandle nh_, private_nh_;
  bool simulated_;
  std::string report_topic_;
  ros::Subscriber poses_, ground_truth_;
  ros::Publisher estimate_, report_;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "localizer");
  Localizer localizer;
  ros::spin();
  return 0;
}
