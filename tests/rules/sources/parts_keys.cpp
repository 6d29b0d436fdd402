// Entries of maps by their keys, and parts of pairs: the one that is asked for, where both keys are written out.
//
// expect: publisher braced
// expect: publisher assigned
// expect: publisher emplaced
// expect: publisher inserted
// expect: publisher at
// expect: publisher pair_first
// expect: publisher pair_second
// expect: publisher of_function
// expect: publisher unknown_key_a
// expect: publisher unknown_key_b
// expect: publisher looped_a
// expect: publisher looped_b
// expect: publisher struct_name
// expect-only: publisher
#include <map>
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <string>
#include <utility>
#include <vector>

std::vector<ros::Publisher> g_pubs;

void open(const std::string& name)
{
  g_pubs.push_back(ros::NodeHandle().advertise<std_msgs::Empty>(name, 1));
}

struct Topic
{
  std::string type;
  std::string name;
  int queue;
};

void openPair(const std::pair<std::string, std::string>& pair)
{
  open(pair.second);
}

const std::map<std::string, std::string> g_braced = {{"a", "braced"}, {"b", "never_braced"}};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "parts");
  ros::NodeHandle nh;
  open(g_braced.at("a"));

  std::map<std::string, std::string> assigned;
  assigned["a"] = "assigned";
  assigned["b"] = "never_assigned";
  if (assigned["a"] == "never_compared")
    return 1;
  open(assigned["a"]);

  std::map<std::string, std::string> emplaced;
  emplaced.emplace("a", "emplaced");
  open(emplaced["a"]);

  std::map<std::string, std::string> inserted;
  inserted.insert(std::make_pair("a", "inserted"));
  open(inserted["a"]);

  std::map<std::string, std::string> at = {{"a", "never_at"}, {"b", "at"}};
  open(at.at("b"));

  std::pair<std::string, std::string> pair("pair_first", "never_pair");
  open(pair.first);
  auto made = std::make_pair("never_made", "pair_second");
  open(made.second);
  openPair(std::make_pair("never_first", "of_function"));

  std::map<std::string, std::string> unknown = {{"a", "unknown_key_a"}, {"b", "unknown_key_b"}};
  open(unknown[argv[1]]);

  std::vector<std::pair<int, std::string>> looped = {{1, "looped_a"}, {2, "looped_b"}};
  for (const auto& each : looped)
    open(each.second);

  Topic topic = {"never_type", "struct_name", 1};
  open(topic.name);
  ros::spin();
}
