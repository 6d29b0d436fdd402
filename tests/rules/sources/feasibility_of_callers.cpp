// A function that makes ports where its parameters say so: each caller makes those that its arguments ask for.
//
// expect: publisher /a/debug
// expect: publisher /a/on
// expect: publisher /b/off
// expect: publisher /c/text
// expect: publisher /d/other
// expect: publisher /e/three
// expect: publisher /f/rest
// expect: publisher /g/unknown
// expect: publisher /g/else
// expect: publisher /h/kind
// expect: publisher /i/nonzero
// expect: publisher /j/zero
// expect: publisher /k/differs
// expect: publisher /l/either
// expect: publisher /m/read
// expect: publisher /m/unread
// expect: publisher /n/mask
// expect: publisher /o/outer
// expect: publisher /o/inner
// expect: publisher /p/given
// expect: publisher /p/not_given
// expect: publisher /q/three
// expect: publisher /q/rest
// expect: publisher /r/on
// expect: publisher /r/off
// expect: publisher /s/on
// expect: publisher /s/off
// expect: publisher /t/three
// expect: publisher /t/rest
// expect: publisher /global
// expect-only: publisher
// expect: Count = count : { never_true(E, C) }, Count = 9
// expect: Count = count : { never_false(E, C) }, Count = 7
// expect: 1 = count : { default_text(_, _) }
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <string>
#include <vector>

typedef std_msgs::Empty Message;

enum Kind
{
  WHEEL,
  ARM
};

enum Flags
{
  READ = 1,
  WRITE = 2
};

std::vector<ros::Publisher> g_pubs;

void open(ros::NodeHandle& nh, const std::string& name, bool debug)
{
  if (debug)
    g_pubs.push_back(nh.advertise<Message>(name + "/debug", 1));
}

void toggle(ros::NodeHandle& nh, const std::string& name, bool enabled)
{
  if (!enabled)
    g_pubs.push_back(nh.advertise<Message>(name + "/off", 1));
  else
    g_pubs.push_back(nh.advertise<Message>(name + "/on", 1));
}

void named(ros::NodeHandle& nh, const std::string& name, const std::string& type)
{
  if (type == "text")
    g_pubs.push_back(nh.advertise<Message>(name + "/text", 1));
  else
    g_pubs.push_back(nh.advertise<Message>(name + "/other", 1));
}

void numbered(ros::NodeHandle& nh, const std::string& name, int number)
{
  if (3 == number)
    g_pubs.push_back(nh.advertise<Message>(name + "/three", 1));
  else
    g_pubs.push_back(nh.advertise<Message>(name + "/rest", 1));
}

void unknown(ros::NodeHandle& nh, const std::string& name, int number)
{
  if (number == 3)
    g_pubs.push_back(nh.advertise<Message>(name + "/unknown", 1));
  else
    g_pubs.push_back(nh.advertise<Message>(name + "/else", 1));
}

void kind(ros::NodeHandle& nh, const std::string& name, Kind kind)
{
  if (kind == ARM)
    g_pubs.push_back(nh.advertise<Message>(name + "/kind", 1));
}

void counted(ros::NodeHandle& nh, const std::string& name, int count)
{
  if (count)
    g_pubs.push_back(nh.advertise<Message>(name + "/nonzero", 1));
  else
    g_pubs.push_back(nh.advertise<Message>(name + "/zero", 1));
}

void differs(ros::NodeHandle& nh, const std::string& name, bool strict)
{
  if (strict != true)
    g_pubs.push_back(nh.advertise<Message>(name + "/differs", 1));
}

void either(ros::NodeHandle& nh, const std::string& name, int number)
{
  if (number > 3)
    g_pubs.push_back(nh.advertise<Message>(name + "/either", 1));
}

void fromParameter(ros::NodeHandle& nh, const std::string& name, bool read)
{
  if (read)
    g_pubs.push_back(nh.advertise<Message>(name + "/read", 1));
  else
    g_pubs.push_back(nh.advertise<Message>(name + "/unread", 1));
}

void masked(ros::NodeHandle& nh, const std::string& name, int flags)
{
  if (flags & READ)
    g_pubs.push_back(nh.advertise<Message>(name + "/mask", 1));
  if (flags & WRITE)
    g_pubs.push_back(nh.advertise<Message>(name + "/never", 1));
}

// what one caller rules out is not made through it
void inner(ros::NodeHandle& nh, const std::string& name)
{
  g_pubs.push_back(nh.advertise<Message>(name, 1));
}

void outer(ros::NodeHandle& nh, const std::string& name, bool special)
{
  if (special)
    inner(nh, "/o/never");
  else
    inner(nh, "/o/inner");
  g_pubs.push_back(nh.advertise<Message>(name + "/outer", 1));
}

void given(ros::NodeHandle& nh, const std::string& name, const char* prefix)
{
  if (prefix)
    g_pubs.push_back(nh.advertise<Message>(name + "/given", 1));
  else
    g_pubs.push_back(nh.advertise<Message>(name + "/not_given", 1));
}

bool isOn();

// nobody calls it
void unused(ros::NodeHandle& nh)
{
  open(nh, "/unused", true);
}

ros::Publisher make()
{
  return ros::NodeHandle().advertise<Message>("/global", 1);
}

ros::Publisher g_pub = make();

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh, private_nh("~");
  open(nh, "/a", true);
  open(nh, "/z", false);
  toggle(nh, "/a", true);
  toggle(nh, "/b", false);
  named(nh, "/c", "text");
  named(nh, "/d", "number");
  numbered(nh, "/e", 3);
  numbered(nh, "/f", 4);
  unknown(nh, "/g", argc);
  kind(nh, "/h", ARM);
  kind(nh, "/y", WHEEL);
  counted(nh, "/i", 2);
  counted(nh, "/j", 0);
  differs(nh, "/k", false);
  differs(nh, "/x", true);
  either(nh, "/l", 1);
  bool read;
  private_nh.param("read", read, false);
  fromParameter(nh, "/m", read);
  masked(nh, "/n", READ);
  outer(nh, "/o", false);
  given(nh, "/p", "text");
  numbered(nh, "/q", argc > 1 ? 3 : 4);
  toggle(nh, "/r", argc > 1 ? true : false);
  toggle(nh, "/s", argc > 1 ? true : isOn());
  numbered(nh, "/t", argc > 1 ? 3 : argc);
  ros::spin();
}
