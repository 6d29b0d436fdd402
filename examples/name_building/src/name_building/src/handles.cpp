#include <memory>
#include <string>
#include <vector>

#include <boost/make_shared.hpp>
#include <ros/ros.h>
#include <std_msgs/Float64.h>

class Part
{
public:
  explicit Part(const ros::NodeHandle& nh) : nh_(nh), inner_(nh, "inner")
  {
  }

protected:
  ros::NodeHandle nh_, inner_;
};

class Motor : public Part
{
public:
  explicit Motor(const ros::NodeHandle& nh) : Part(nh)
  {
    speed_ = nh_.advertise<std_msgs::Float64>("speed", 1);
    current_ = inner_.advertise<std_msgs::Float64>("current", 1);
  }

private:
  ros::Publisher speed_, current_;
};

class Late
{
public:
  void configure()
  {
    nh_ = ros::NodeHandle("late");
    own_.reset(new ros::NodeHandle("~/own"));
    shared_ = boost::make_shared<ros::NodeHandle>(nh_, "shared");
  }

  void advertise()
  {
    publishers_.push_back(nh_.advertise<std_msgs::Float64>("a", 1));
    publishers_.push_back(own_->advertise<std_msgs::Float64>("b", 1));
    publishers_.push_back(shared_->advertise<std_msgs::Float64>("c", 1));
  }

private:
  ros::NodeHandle nh_;
  std::unique_ptr<ros::NodeHandle> own_;
  ros::NodeHandlePtr shared_;
  std::vector<ros::Publisher> publishers_;
};

ros::NodeHandle inNamespace(const std::string& name)
{
  return ros::NodeHandle(name);
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "handles");
  ros::NodeHandle nh, pnh("~"), deep(pnh, "deep"), copy = deep;
  Motor left(ros::NodeHandle("left")), plain(nh);
  Late late;
  late.configure();
  late.advertise();

  std::vector<ros::Publisher> publishers;
  publishers.push_back(copy.advertise<std_msgs::Float64>("x", 1));
  publishers.push_back(pnh.advertise<std_msgs::Float64>("/absolute", 1));
  publishers.push_back(inNamespace("made").advertise<std_msgs::Float64>("x", 1));

  // whole names are remapped, not parts of them
  ros::M_string remappings;
  remappings["from"] = "to";
  ros::NodeHandle remapping("arm", remappings);
  publishers.push_back(remapping.advertise<std_msgs::Float64>("from", 1));
  publishers.push_back(remapping.advertise<std_msgs::Float64>("from/x", 1));
  ros::NodeHandle elsewhere(nh, "", { { "in", "/everywhere" } });
  publishers.push_back(elsewhere.advertise<std_msgs::Float64>("in", 1));

  publishers.push_back(nh.advertise<std_msgs::Float64>(pnh.resolveName("resolved"), 1));
  publishers.push_back(nh.advertise<std_msgs::Float64>(ros::names::append("joined", "x"), 1));
  publishers.push_back(nh.advertise<std_msgs::Float64>(ros::this_node::getName() + "/named", 1));
  ros::spin();
  return 0;
}
