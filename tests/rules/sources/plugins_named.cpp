// The base that a loader was told, as a local variable and as a member; a parameter that names the class; a loader that was told in no words.
//
// expect: plugin_named(_, "shapes/Square", "", "shapes::Shape", "shapes")
// expect: plugin_named(_, "shapes/Circle", "~shape", "shapes::Shape", "shapes")
// expect: plugin_named(_, "shapes/Star", "", "", "")
// expect: plugin_named(_, "shapes/Heart", "", "shapes::Shape", "")
// expect: 4 = count : { plugin_named(_, _, _, _, _) }
#include <pluginlib/class_loader.h>
#include <ros/ros.h>

namespace shapes {
struct Shape {
  virtual ~Shape() {}
};
}  // namespace shapes

struct Box {
  Box() : loader_("shapes", "shapes::Shape") {
    std::string name;
    ros::NodeHandle("~").param<std::string>("shape", name, "shapes/Circle");
    shape_ = loader_.createInstance(name);
  }
  pluginlib::ClassLoader<shapes::Shape> loader_;
  boost::shared_ptr<shapes::Shape> shape_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "box");
  Box box;
  pluginlib::ClassLoader<shapes::Shape> loader("shapes", "shapes::Shape");
  auto square = loader.createInstance("shapes/Square");
  std::string base = argv[1];
  pluginlib::ClassLoader<shapes::Shape> other("shapes", base);
  auto star = other.createInstance("shapes/Star");
  pluginlib::ClassLoader<shapes::Shape> third(base, "shapes::Shape");
  auto heart = third.createInstance("shapes/Heart");
  ros::spin();
}
