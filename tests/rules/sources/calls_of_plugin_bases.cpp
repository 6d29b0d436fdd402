// A plug-in is initialised by its host through a method of its base class, which calls what the plug-in overrides: the name is the host's.
//
// expect: N = count : { port(_) }, N = 2
// expect: port([_, "subscriber", "?/mask"])
// expect: publisher fixed std_msgs/Bool
#include <string>
#include <pluginlib/class_list_macros.h>
#include <ros/ros.h>
#include <std_msgs/Bool.h>

namespace layers {

class Layer {
public:
  Layer() : name_() {}
  virtual ~Layer() {}
  void initialize(const std::string& name) {
    name_ = name;
    onInitialize();
  }
  virtual void onInitialize() {}

protected:
  std::string name_;
};

class Keepout : public Layer {
public:
  void onInitialize() override {
    ros::NodeHandle nh;
    mask_ = nh.subscribe(name_ + "/mask", 1, &Keepout::onMask, this);
    fixed_ = nh.advertise<std_msgs::Bool>("fixed", 1);
  }

private:
  void onMask(const std_msgs::Bool::ConstPtr&) {}

  ros::Subscriber mask_;
  ros::Publisher fixed_;
};

}

PLUGINLIB_EXPORT_CLASS(layers::Keepout, layers::Layer)
