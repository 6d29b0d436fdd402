// Names that the code itself remaps: by maps given to handles, and by maps given to ros::init for all of the node.
//
// expect: publisher /new std_msgs/Empty
// expect: publisher kept std_msgs/Empty
// expect: publisher ns/second std_msgs/Empty
// expect: publisher braced_new std_msgs/Empty
// expect: publisher paired_new std_msgs/Empty
// expect: publisher inserted_new std_msgs/Empty
// expect: publisher copied_new std_msgs/Empty
// expect: publisher everywhere_new std_msgs/Empty
// expect: publisher braced std_msgs/Empty
// expect-only: publisher
// expect: Count = count : { handle_remaps(C, M) }, Count = 5
// expect: Count = count : { node_remaps(M), map_entry(M, Key, Value) }, Count = 1
// expect: Count = count : { remapped(Site, Context, From, To), To != "everywhere_new" }, Count = 16
#include <map>
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <string>
#include <utility>

typedef std::map<std::string, std::string> Remappings;

// nobody calls it
void unused(int argc, char** argv)
{
  Remappings never;
  never["kept"] = "never";
  ros::init(argc, argv, never, "other");
}

int main(int argc, char** argv)
{
  Remappings all;
  all["everywhere"] = "everywhere_new";
  ros::init(argc, argv, "node");
  ros::init(all, "node");
  ros::NodeHandle nh;

  Remappings remappings;
  remappings["old"] = "/new";
  remappings["first"] = "second";
  Remappings other;
  other["kept"] = "lost";
  ros::NodeHandle handle("", remappings), inner("ns", remappings);
  ros::Publisher old_pub = handle.advertise<std_msgs::Empty>("old", 1);
  ros::Publisher kept_pub = handle.advertise<std_msgs::Empty>("kept", 1);
  ros::Publisher first_pub = inner.advertise<std_msgs::Empty>("first", 1);

  Remappings list = {{"braced", "braced_new"}};
  list.insert(std::make_pair("paired", "paired_new"));
  list.insert(std::pair<std::string, std::string>("inserted", "inserted_new"));
  ros::NodeHandle listed("", list);
  ros::Publisher braced_pub = listed.advertise<std_msgs::Empty>("braced", 1);
  ros::Publisher paired_pub = listed.advertise<std_msgs::Empty>("paired", 1);
  ros::Publisher inserted_pub = listed.advertise<std_msgs::Empty>("inserted", 1);

  Remappings original;
  original["copied"] = "copied_new";
  Remappings copy(original);
  ros::NodeHandle copied("", copy);
  ros::Publisher copied_pub = copied.advertise<std_msgs::Empty>("copied", 1);

  ros::NodeHandle temporary("", Remappings{{"brief", "brief_new"}});
  ros::Publisher everywhere_pub = nh.advertise<std_msgs::Empty>("everywhere", 1);
  ros::Publisher plain_pub = nh.advertise<std_msgs::Empty>("braced", 1);
  ros::spin();
}
