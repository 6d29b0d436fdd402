// Names that are parts of pairs, of a map's entries and of plain structures, however these are reached.
//
// expect: subscriber /pair
// expect: subscriber /made
// expect: subscriber /pointed
// expect: subscriber /entry
// expect: subscriber /assigned
// expect: subscriber /emplaced
// expect: subscriber /at
// expect: subscriber /key
// expect: subscriber /struct
// expect: subscriber /front
// expect-not: subscriber ?
// expect-not: subscriber *other*
// expect-not: of_other_key(_, _)
#include <map>
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <string>
#include <utility>
#include <vector>

struct Topic
{
  std::string name;
  int queue;
};

void onMessage(const std_msgs::Empty&)
{
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  std::vector<ros::Subscriber> subs;

  std::pair<std::string, std::string> pair{"/pair", "/other"};
  subs.push_back(nh.subscribe(pair.first, 1, onMessage));

  auto made = std::make_pair(std::string("/other"), std::string("/made"));
  subs.push_back(nh.subscribe(made.second, 1, onMessage));

  std::pair<std::string, int> target{"/pointed", 1};
  std::pair<std::string, int>* pointer = &target;
  subs.push_back(nh.subscribe(pointer->first, 1, onMessage));
  subs.push_back(nh.subscribe((*pointer).first, 1, onMessage));

  std::vector<std::pair<std::string, int>> entries;
  entries.push_back(std::make_pair("/entry", 1));
  subs.push_back(nh.subscribe(entries[0].first, 1, onMessage));
  for (const auto& entry : entries)
    subs.push_back(nh.subscribe(entry.first, 1, onMessage));

  std::vector<std::pair<std::string, int>> listed{{"/front", 1}};
  subs.push_back(nh.subscribe(listed.front().first, 1, onMessage));

  std::map<std::string, std::string> assigned;
  assigned["/key"] = "/assigned";
  for (const auto& entry : assigned)
  {
    subs.push_back(nh.subscribe(entry.first, 1, onMessage));
    subs.push_back(nh.subscribe(entry.second, 1, onMessage));
  }

  std::map<std::string, std::string> emplaced;
  emplaced.emplace("other", "/emplaced");
  subs.push_back(nh.subscribe(emplaced["other"], 1, onMessage));

  std::map<std::string, std::string> map{{"other", "/at"}};
  subs.push_back(nh.subscribe(map.at("other"), 1, onMessage));

  Topic topic = {"/struct", 1};
  subs.push_back(nh.subscribe(topic.name, topic.queue, onMessage));
  ros::spin();
}
