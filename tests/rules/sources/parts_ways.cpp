// Parts of pairs, maps and structures: only those that names are made of, and only by their own place.
//
// expect: N = count : { part(_, _, _) }, N = 50
// expect: N = count : { part_use(_, _, _) }, N = 17
// expect: N = count : { plain_object(_, _) }, N = 98
// expect: N = count : { field_index(Field, _), location(Field, _, _, _) }, N = 4
// expect: N = count : { inserted_entry(_, _) }, N = 21
// expect: N = count : { definition_target(_, _) }, N = 7
// expect: N = count : { map_access(_, _) }, N = 6
// expect: N = count : { other_object(_, _) }, N = 4
// expect: N = count : { wanted(_) }, N = 87
// expect-only: subscriber
#include <list>
#include <map>
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

struct Topic
{
  static int count;
  std::string name;
  int queue;
  std::string frame;
};
int Topic::count = 0;

struct Place
{
  std::string name;
};

class Options
{
public:
  std::string name, frame;
  int queue;
};

typedef std::pair<std::string, std::string> Entry;

void onMessage(const std_msgs::Empty&)
{
}

std::vector<ros::Subscriber> g_subs;

void subscribe(ros::NodeHandle& nh, const Topic& topic)
{
  g_subs.push_back(nh.subscribe(topic.name, 1, onMessage));  // expect: subscriber /topic
}

void subscribe(ros::NodeHandle& nh, const Entry& entry)
{
  g_subs.push_back(nh.subscribe(entry.first, 1, onMessage));  // expect: subscriber /entry
}

// none of these parts is a name
int irrelevant(const Topic& given)
{
  Options topic;
  Place place;
  place.name = "/place";
  Entry entry("/first", "/second");
  entry = std::make_pair("/third", "/fourth");
  std::map<std::string, Options> topics;
  topics["a"] = topic;
  topics["a"].queue = 3;
  std::vector<Entry> entries{{"/fifth", "/sixth"}};
  entries.push_back(std::make_pair("/seventh", "/eighth"));
  std::list<std::string> names;
  names.push_back(entry.first);
  topic.frame = entries.front().second + topics.at("a").frame;
  return topic.queue + entry.second.size() + given.queue;
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  irrelevant(Topic());

  Topic topic = {"/topic", 2, "/frame"};
  g_subs.push_back(nh.subscribe(topic.frame, topic.queue, onMessage));  // expect: subscriber /frame queue=2
  subscribe(nh, topic);
  Options options;
  options.name = "/options";
  g_subs.push_back(nh.subscribe(options.name, 1, onMessage));  // expect: subscriber /options
  Place left, right;
  left.name = "/left";
  right.name = "/right";
  g_subs.push_back(nh.subscribe(left.name, 1, onMessage));  // expect: subscriber /left
  g_subs.push_back(nh.subscribe(right.name, 1, onMessage));  // expect: subscriber /right

  Entry pair("/first", "/second");
  g_subs.push_back(nh.subscribe(pair.first, 1, onMessage));  // expect: subscriber /first
  Entry later;
  later = std::make_pair("/third", "/fourth");
  g_subs.push_back(nh.subscribe(later.second, 1, onMessage));  // expect: subscriber /fourth
  subscribe(nh, Entry("/entry", "/no_entry"));
  const Entry copy = pair;
  const Entry* pointer = &copy;
  g_subs.push_back(nh.subscribe(pointer->second, 1, onMessage));  // expect: subscriber /second
  auto cast = static_cast<const Entry&>(later);
  g_subs.push_back(nh.subscribe(cast.first, 1, onMessage));  // expect: subscriber /third

  std::list<Topic> topics;
  topics.push_back({"/listed", 1, "/no_name"});
  for (const Topic& each : topics)
    g_subs.push_back(nh.subscribe(each.name, 1, onMessage));  // expect: subscriber /listed
  g_subs.push_back(nh.subscribe(topics.front().name, 1, onMessage));  // expect: subscriber /listed
  const Topic table[] = {{"/upper", 1, "/no_name"}, {"/lower", 2, "/no_name"}};
  // expect: subscriber /upper
  g_subs.push_back(nh.subscribe(table[1].name, 1, onMessage));  // expect: subscriber /lower

  std::unordered_map<std::string, std::string> map{{"key", "/value"}};
  map["other"] = "/other_value";
  map.insert(std::make_pair("third", "/third_value"));
  map.emplace("fourth", "/fourth_value");
  // expect: subscriber /value
  // expect: subscriber /other_value
  // expect: subscriber /third_value
  g_subs.push_back(nh.subscribe(map[argv[0]], 1, onMessage));  // expect: subscriber /fourth_value
  const Topic* chosen = &topic;
  g_subs.push_back(nh.subscribe(chosen->name, 1, onMessage));  // expect: subscriber /topic
  std::map<std::string, int> queues;
  queues["/queued"] = 5;
  for (const auto& each : queues)
    g_subs.push_back(nh.subscribe(each.first, each.second, onMessage));  // expect: subscriber /queued queue=5
  ros::spin();
}
