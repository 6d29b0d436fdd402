// What is a number, what counts, and what is calculated: only where a name, a rate or another answer is made of it.
//
// expect: N = count : { numeric(_) }, N = 59
// expect: N = count : { number_variable(_) }, N = 15
// expect: N = count : { pointer_use(_, _) }, N = 13
// expect: N = count : { steps_through(_) }, N = 3
// expect: N = count : { counter(_, _, _) }, N = 3
// expect: N = count : { counted(_) }, N = 26
// expect: N = count : { calculation(_, _, _, _) }, N = 4
// expect: N = count : { counted_up(_) }, N = 3
// expect: N = count : { wanted(_) }, N = 130
// expect: N = count : { variable_wanted(_) }, N = 23
// expect-only: publisher
// expect-only: periodic
// expect: 14 = count : { joined_text(_, _, _) }, 5 = count : { message_content(_, _) }, 2 = count : { round_sends(_, _, _) }
#include <ros/ros.h>
#include <std_msgs/Int32.h>
#include <string>
#include <vector>

const int LAST = 2;
constexpr int MOST = 2 + 1;
ros::NodeHandle* g_nh;
ros::Publisher g_pub;
std::vector<ros::Publisher> g_pubs;

void advertise(const std::string& name, const int& queue)
{
  g_pubs.push_back(g_nh->advertise<std_msgs::Int32>(name, queue));
}

// no number here takes part in an answer
int irrelevant(const int& factor, int& sum)
{
  const double weight = 0.5;
  float offset = 1.5f;
  const char* text = "text";
  int steps = 0;
  for (const char* at = text; *at; ++at)
    ++steps;
  for (int i = 0; i < MOST; ++i)
    sum += factor * i;
  sum += 3;
  offset = -offset * 2 + weight / 2;
  return sum * 2 + LAST - steps;
}

void onTimer(const ros::TimerEvent&)
{
  std_msgs::Int32 message;
  int sum = 0;
  message.data = irrelevant(2, sum);
  g_pub.publish(message);
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  g_nh = &nh;

  // expect: publisher /first_0
  for (int i = 0; i < LAST; ++i)
    g_pubs.push_back(nh.advertise<std_msgs::Int32>("/first_" + std::to_string(i), 1));  // expect: publisher /first_1
  // expect: publisher /second_1
  for (int i = 1; i != MOST; i++)
    g_pubs.push_back(nh.advertise<std_msgs::Int32>("/second_" + std::to_string(i), 1));  // expect: publisher /second_2
  for (int i = 0; i < 100; ++i)
    g_pubs.push_back(nh.advertise<std_msgs::Int32>("/many/" + std::to_string(i), 1));  // expect: publisher ?
  for (int i = 0; i < argc; ++i)
    g_pubs.push_back(nh.advertise<std_msgs::Int32>("/given/" + std::to_string(i), 1));  // expect: publisher ?
  for (int i = 0; i < 4; ++i)
  {
    if (i > 1)
      i = 3;
    g_pubs.push_back(nh.advertise<std_msgs::Int32>("/jumping/" + std::to_string(i), 1));  // expect: publisher ?
  }
  int number = 0;
  while (number < 3)
  {
    g_pubs.push_back(nh.advertise<std_msgs::Int32>("/while/" + std::to_string(number), 1));  // expect: publisher ?
    number++;
  }
  int most = 2;
  for (int i = 0; i < most; ++i)
    g_pubs.push_back(nh.advertise<std_msgs::Int32>("/unsure/" + std::to_string(i), 1));  // expect: publisher ?

  // expect: publisher /half_0
  for (int i = 0; i < 4 / 2; ++i)
    g_pubs.push_back(nh.advertise<std_msgs::Int32>("/half_" + std::to_string(i), 1));  // expect: publisher /half_1

  const std::vector<std::string> names = {"/left", "/right"};
  // expect: publisher /left
  for (std::vector<std::string>::const_iterator it = names.begin(); it != names.end(); ++it)
    g_pubs.push_back(nh.advertise<std_msgs::Int32>(*it, 1));  // expect: publisher /right
  const char* const ends[] = {"/up", "/down"};
  // expect: publisher /up
  for (const char* const* end = ends; end != ends + 2; ++end)
    g_pubs.push_back(nh.advertise<std_msgs::Int32>(*end, 1));  // expect: publisher /down

  int size = 2;
  const double scale = 2.0;
  unsigned char small = 3;
  // expect: publisher /sum queue=5
  advertise("/sum", size + 3);
  g_pubs.push_back(nh.advertise<std_msgs::Int32>("/difference", MOST - size));  // expect: publisher /difference queue=1
  g_pubs.push_back(nh.advertise<std_msgs::Int32>("/product", small * 4));  // expect: publisher /product queue=12
  g_pubs.push_back(nh.advertise<std_msgs::Int32>("/constant", MOST * 2));  // expect: publisher /constant queue=6
  g_pubs.push_back(nh.advertise<std_msgs::Int32>("/negative" + std::to_string(-2), 1));  // expect: publisher /negative-2
  int counted = 1;
  counted += 2;
  g_pubs.push_back(nh.advertise<std_msgs::Int32>("/counted", counted));  // expect: publisher /counted queue=

  g_pub = nh.advertise<std_msgs::Int32>("/timed", 1);  // expect: publisher /timed
  double period = 0.5;
  // expect: periodic /timed 1 Hz
  ros::Timer slow = nh.createTimer(ros::Duration(period * scale), onTimer);
  // expect: periodic /timed 4 Hz
  ros::Timer fast = nh.createTimer(ros::Duration(period / 2), onTimer);
  ros::spin();
}
