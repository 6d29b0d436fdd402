// What gives a text its value, and what leaves it unknown.
//
// expect: N = count : { definition(_, _) }, N = 63
// expect: N = count : { garbled(_, _) }, N = 8
// expect: N = count : { extracts(_, _, _) }, N = 2
// expect: N = count : { text_variable(_) }, N = 35
// expect: N = count : { reaches(_, _) }, N = 77
// expect: N = count : { entry_reaches(_) }, N = 22
// expect: N = count : { parameter_changed(_, _) }, N = 5
// expect: N = count : { written_through(_) }, N = 2
// expect: N = count : { written_on(_) }, N = 6
// expect: N = count : { appended(_, _, _) }, N = 11
// expect: N = count : { inserted(_, _, _) }, N = 1
// expect: N = count : { prepended(_, _, _) }, N = 4
// expect: N = count : { cut(_, _, _) }, N = 5
// expect: N = count : { feeds_itself(_) }, N = 1
// expect: N = count : { outer_use(_, _) }, N = 6
// expect-only: subscriber
// expect: N = count : { number_variable(_) }, N = 2
// expect: 8 = count : { operand_values(_, _, _, _, _, _) }
#include <boost/algorithm/string.hpp>
#include <algorithm>
#include <cstdio>
#include <ros/ros.h>
#include <sstream>
#include <std_msgs/Empty.h>
#include <string>
#include <vector>

void onMessage(const std_msgs::Empty&)
{
}

ros::NodeHandle* g_nh;
std::vector<ros::Subscriber> g_subs;

void subscribe(const std::string& name);  // defined below
void rename(std::string& name);  // in a library
void renameAt(std::string* name);  // in a library
void look(const std::string& name);  // in a library

void add(std::string& name)
{
  name += "/added";
}

void replace(std::string* name)
{
  *name = "/replaced";
}

void addTwo(std::string& first, std::string& second)
{
  first += "/one";
  second += "/two";
}

void keep(const std::string& name, std::string copy, int* number)
{
  copy = name;
  *number = 1;
}

// none of these texts takes part in an answer
std::string irrelevant(const std::string& name)
{
  std::string text = name;
  text += "x";
  text.append("y");
  text.insert(0, "z");
  text.erase(0, 1);
  text[0] = 'w';
  text.clear();
  std::stringstream stream;
  stream << text << 1;
  stream >> text;
  rename(text);
  char buffer[20];
  sprintf(buffer, "%s", text.substr(1).c_str());
  return buffer;
}

class Names
{
public:
  Names() : frame_("/frame")
  {
  }
  void subscribeAll();

private:
  std::string frame_;
  std::string later_;
};

struct Topic
{
  std::string name;
  int queue;
};

void changed()
{
  std::string a = "/a";
  add(a);
  // expect: subscriber /a/added
  subscribe(a);
  std::string b = "/b";
  replace(&b);
  // expect: subscriber /replaced
  subscribe(b);
  std::string two = "/c", one = "/b";
  addTwo(one, two);
  // expect: subscriber /b/one
  subscribe(one);
  // expect: subscriber /c/two
  subscribe(two);
  std::string c = "/c";
  int number = 0;
  keep(c, c, &number);
  look(c);
  // expect: subscriber /c
  subscribe(c);
  std::string d = "/d";
  rename(d);
  // expect: subscriber ?
  subscribe(d);
  std::string e = "/e";
  renameAt(&e);
  subscribe(e);
  std::string f = "/f";
  boost::to_upper(f);
  subscribe(f);
  std::string g = "/g";
  std::reverse(g.begin(), g.end());
  subscribe(g);
  std::string h = "/h";
  h[1] = 'x';
  subscribe(h);
  std::string i = "/i";
  i.erase(1, 1);
  subscribe(i);
}

void written(char** argv)
{
  std::ostringstream one;
  one << "/one";
  // expect: subscriber /one
  subscribe(one.str());
  std::stringstream two;
  two << "/two" << '_' << 2;
  // expect: subscriber /two_2
  subscribe(two.str());
  std::stringstream words("/first /second");
  std::string word;
  words >> word;
  // expect: subscriber /first
  // expect: subscriber /second
  subscribe(word);
  std::stringstream numbers("3");
  int number = 4;
  numbers >> number;
  char buffer[20], other[20];
  sprintf(buffer, "/made_%d", 3);
  // expect: subscriber /made_3
  subscribe(buffer);
  snprintf(other, 20, "/%s/%s", argv[1], "known");
  // expect: subscriber ?/known
  subscribe(other);
  snprintf(other, 20, "/%5.1f", 0.5);
  subscribe(other);
  std::string assigned;
  assigned.assign("/assigned");
  // expect: subscriber /assigned
  subscribe(assigned);
  std::string emptied = "/before";
  emptied.clear();
  emptied.append("/appended");
  // expect: subscriber /appended
  subscribe(emptied);
  emptied.push_back('s');
  // expect: subscriber /appendeds
  subscribe(emptied);
}

void cutAndPut(char** argv)
{
  std::string put = "put";
  put.insert(0, "/");
  // expect: subscriber /put
  subscribe(put);
  put.insert(put.begin(), '/');
  put.insert(0, 1, 'x');
  // expect: subscriber x/put
  subscribe(put);
  put.insert(2, "y");
  subscribe(put);
  const std::string whole = "/whole/part";
  // expect: subscriber /part
  subscribe(whole.substr(6));
  // expect: subscriber /whole
  subscribe(whole.substr(0, 6));
  // expect: subscriber /part/known
  subscribe(whole.substr(whole.rfind('/')) + "/known");
  subscribe(whole.substr(0, whole.rfind('/')));
  const std::string given = argv[1];
  // expect: subscriber ?/after
  subscribe(given.substr(1) + "/after");
}

void chosen(bool on, int count)
{
  std::string name = "/off";
  if (on)
    name = "/on";
  // expect: subscriber /on
  subscribe(name);
  // expect: subscriber /off
  std::string last = "/never";
  last = "/last";
  // expect: subscriber /last
  subscribe(last);
  std::string text = "/text";
  for (int i = 0; i < count; ++i)
    text = text + "x";
  // expect: subscriber /text
  subscribe(text);
  static std::string kept = "/kept";
  // expect: subscriber /kept
  subscribe(kept);
  std::string captured = "/captured";
  // expect: subscriber /captured
  auto call = [&captured]() { subscribe(captured); };
  call();
  Topic left, right;
  left.name = "/left";
  right.name = "/right";
  // expect: subscriber /left
  subscribe(left.name);
  // expect: subscriber /right
  subscribe(right.name);
  Topic& same = left;
  same.name = "/same";
  // expect: subscriber /same
  subscribe(same.name);
}

void Names::subscribeAll()
{
  // expect: subscriber /frame
  subscribe(frame_);
  later_ = "/later";
  // expect: subscriber /later
  subscribe(later_);
}

void subscribe(const std::string& name)
{
  g_subs.push_back(g_nh->subscribe(name, 1, onMessage));
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  g_nh = &nh;
  irrelevant("text");
  changed();
  written(argv);
  cutAndPut(argv);
  chosen(argc > 1, argc);
  Names names;
  names.subscribeAll();
  ros::spin();
}
