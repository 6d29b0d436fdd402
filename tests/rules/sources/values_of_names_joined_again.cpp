// A function that joins names through another one, and is given what it made: there is no end of the texts where its callers come together.
//
// expect: param ?
// expect: param plain/rate
// expect-only: param
// expect-not: value(_, _, Text, _), match(".*/x/.*", Text)
#include <ros/ros.h>

#include <string>

std::string tidy(const std::string& name) {
  std::string tidied = name;
  if (*tidied.rbegin() == '/') tidied.erase(tidied.size() - 1, 1);
  return tidied;
}

std::string join(const std::string& left, const std::string& right) { return tidy(left + "/" + right); }

std::string once(const std::string& left, const std::string& right) { return left + "/" + right; }

int main(int argc, char** argv) {
  ros::init(argc, argv, "joined");
  ros::NodeHandle nh;
  double x;
  std::string space = join("robot", "map");
  nh.getParam(join(space, "x"), x);
  nh.getParam(once("plain", "rate"), x);
}
