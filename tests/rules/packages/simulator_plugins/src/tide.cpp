// A plug-in of Gazebo, registered in its namespace: Load is called by the simulator, callbacks by what it spins.
//
// expect: component tide::Plugin kind=gazebo_plugin
// expect: subscriber set_level std_msgs/Float64
// expect: publisher /tide std_msgs/Float64
// expect: publisher ?/level std_msgs/Float64
#include <gazebo/gazebo.hh>
#include <ros/ros.h>
#include <std_msgs/Float64.h>

namespace tide
{
class Plugin : public gazebo::WorldPlugin
{
public:
  void Load(gazebo::physics::WorldPtr world, sdf::ElementPtr sdf)
  {
    node_.reset(new ros::NodeHandle());
    named_.reset(new ros::NodeHandle(sdf->GetElement("robotNamespace")->Get<std::string>()));
    level_sub_ = node_->subscribe("set_level", 1, &Plugin::onLevel, this);
    tide_pub_ = node_->advertise<std_msgs::Float64>("/tide", 1);
    level_pub_ = named_->advertise<std_msgs::Float64>("level", 1);
    connection_ = gazebo::event::Events::ConnectWorldUpdateBegin(boost::bind(&Plugin::onUpdate, this));
  }

private:
  void onLevel(const std_msgs::Float64& message)
  {
    tide_pub_.publish(message);  // expect: reactive set_level -> /tide must
  }

  void onUpdate()
  {
    level_pub_.publish(std_msgs::Float64());
  }

  std::unique_ptr<ros::NodeHandle> node_, named_;
  ros::Subscriber level_sub_;
  ros::Publisher tide_pub_, level_pub_;
  gazebo::event::ConnectionPtr connection_;
};

GZ_REGISTER_WORLD_PLUGIN(Plugin)
}  // namespace tide
