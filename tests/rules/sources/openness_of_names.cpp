// Ports whose names code may change that was not seen: they may have other names. What cannot change them leaves them alone.
//
// expect: open_at("ports", C, ["otherwise", "chosen"])
// expect: open_at("ports", C, ["otherwise", "extracted"])
// expect: open_at("ports", C, ["otherwise", "lent"])
// expect: open_at("ports", C, ["otherwise", "pointed"])
// expect: Count = count : { open_at("ports", C, Reason) }, Count = 4
// expect: Count = count : { port([S, K, N]), substr(N, 0, 1) = "?" }, Count = 0
#include <absent_conf/conf.h>
#include <ros/ros.h>
#include <std_msgs/String.h>

void publish(ros::NodeHandle& nh, const std::string& name)
{
  static ros::Publisher publisher = nh.advertise<std_msgs::String>(name, 1);
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "named");
  ros::NodeHandle nh;
  absent_conf::Conf conf;
  std::string chosen = "chosen";
  if (conf.wants("name"))
    chosen = conf.name();
  nh.advertise<std_msgs::String>(chosen, 1);
  std::string extracted("extracted");
  if (conf["name"])
    conf["name"] >> extracted;
  nh.advertise<std_msgs::String>(extracted, 1);
  std::string lent = "lent", pointed = "pointed";
  conf.get("name", lent);
  nh.advertise<std_msgs::String>(lent, 1);
  absent_conf::get("name", &pointed);
  nh.advertise<std_msgs::String>(pointed, 1);

  const std::string constant = "constant";
  conf.show(constant);
  nh.advertise<std_msgs::String>(constant, 1);
  std::string later = "later";
  nh.advertise<std_msgs::String>(later, 1);
  conf.get("name", later);
  std::string copied = "copied";
  absent_conf::Title title(copied);
  nh.advertise<std_msgs::String>(copied, 1);
  publish(nh, "given");
  ros::spin();
}
