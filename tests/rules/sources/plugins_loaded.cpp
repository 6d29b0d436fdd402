// Plug-ins that are loaded by names: constants, parameters, and names that nobody knows.
//
// expect: Count = count : { plugin_load(C, Name) }, Count = 5
// expect: plugin_load(_, "tools/Hammer")
// expect: plugin_load(_, "tools/Saw")
// expect: plugin_load(_, "tools/Drill")
// expect: Count = count : { plugin_load_any(C, Base) }, Count = 2
// expect: Count = count : { plugin_load_any(C, "Tool") }, Count = 1
// expect: Count = count : { plugin_load_any(C, "Part") }, Count = 1
// expect: N = count : { as_given(_, _, _) }, N = 5
// expect-not: chained_type(_, _); _type_operand(_, _)
// expect: 10 = count : { assigned_value(_, _, _) }
#include <boost/shared_ptr.hpp>
#include <pluginlib/class_loader.h>
#include <ros/ros.h>
#include <string>

class Tool
{
public:
  virtual ~Tool() {}
};

class Part
{
public:
  virtual ~Part() {}
};

class Bench
{
public:
  Bench() : tools_("tools", "Tool"), parts_(new pluginlib::ClassLoader<Part>("tools", "Part"))
  {
  }

  pluginlib::ClassLoader<Part>& parts()
  {
    return *parts_;
  }

  void load(const std::string& name)
  {
    hammer_ = tools_.createInstance("tools/Hammer");
    std::string saw;
    ros::NodeHandle("~").param<std::string>("saw", saw, "tools/Saw");
    saw_ = tools_.createInstance(saw);
    any_ = tools_.createInstance(name);
    part_ = parts().createInstance(name);
    drill_.reset(tools_.createUnmanagedInstance("tools/Drill"));
  }

  // nobody calls it
  void unused()
  {
    hammer_ = tools_.createInstance("tools/Never");
  }

private:
  pluginlib::ClassLoader<Tool> tools_;
  boost::shared_ptr<pluginlib::ClassLoader<Part>> parts_;
  boost::shared_ptr<Tool> hammer_, saw_, any_, drill_;
  boost::shared_ptr<Part> part_;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  Bench bench;
  bench.load(argv[1]);
  ros::spin();
}
