// What variables are when no parameter is set, however they are read, and the ways through a function that this rules out.
//
// expect: N = count : { read_into(_, _) }, N = 15
// expect: N = count : { fallback(_, _, _) }, N = 2
// expect: N = count : { has_fallback(_) }, N = 2
// expect: N = count : { default_text(_, _) }, N = 9
// expect: N = count : { default_truth(_, _) }, N = 29
// expect: N = count : { off_by_default(_) }, N = 12
// expect: N = count : { handed_on_otherwise(_, _) }, N = 9
// expect: N = count : { constant_text(_, "") }, N = 5
// expect: N = count : { put_aside(_) }, N = 6
// expect: N = count : { definition(_, _) }, N = 47
// expect: N = count : { reaches(_, _) }, N = 60
// expect-only: subscriber
// expect-only: param
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <string>

enum Side
{
  LEFT,
  RIGHT
};

void onMessage(const std_msgs::Empty&)
{
}

int twice(int& number)
{
  return 2 * number;
}

class Node
{
public:
  Node() : private_nh_("~"), scan_("/scan"), debug_(false), rate_(10)
  {
    private_nh_.getParam("scan", scan_);  // expect: param ~scan = /scan
    private_nh_.getParam("debug", debug_);  // expect: param ~debug = false
    rate_ = private_nh_.param("rate", rate_);  // expect: param ~rate = 10
    readNames();
    chooseMode();
    chooseSide();
    choose();
    subs_[0] = nh_.subscribe(scan_, 1, onMessage);  // expect: subscriber /scan from_param=~scan
  }

private:
  void readNames()
  {
    std::string odom, imu, map, joy("/joy"), gps = std::string("/gps"), text = std::string(), other;
    if (!private_nh_.getParam("odom", odom))  // expect: param ~odom = /odom
      odom = "/odom";
    if (private_nh_.getParam("imu", imu))  // expect: param ~imu = /imu
      ROS_INFO("imu");
    else
      imu = std::string("/imu");
    bool given = private_nh_.hasParam("map");  // expect: param ~map op=has
    if (given)
      map = "/given";
    else
      map = "/map";
    other = "/before";
    private_nh_.getParam("joy", joy);  // expect: param ~joy = /joy
    private_nh_.getParam("gps", gps);  // expect: param ~gps = /gps
    private_nh_.getParam("text", text);  // expect: param ~text
    private_nh_.getParam("other", other);  // expect: param ~other = /before
    subs_[1] = nh_.subscribe(odom, 1, onMessage);  // expect: subscriber /odom from_param=~odom
    subs_[2] = nh_.subscribe(imu, 1, onMessage);  // expect: subscriber /imu from_param=~imu
    // expect: subscriber /given
    subs_[3] = nh_.subscribe(map, 1, onMessage);  // expect: subscriber /map
    subs_[4] = nh_.subscribe(joy, 1, onMessage);  // expect: subscriber /joy from_param=~joy
    subs_[5] = nh_.subscribe(gps, 1, onMessage);  // expect: subscriber /gps from_param=~gps
    if (text.empty())
      subs_[6] = nh_.subscribe(other, 1, onMessage);  // expect: subscriber /before from_param=~other
  }

  void chooseMode()
  {
    std::string first = "/start", second = "/start";
    int mode;
    mode = private_nh_.param("mode", 2);  // expect: param ~mode = 2
    switch (mode)
    {
      case 1:
        first = "/one";
        break;
      case 2:
        first = "/two";
        break;
      default:
        first = "/many";
    }
    switch (mode)
    {
      case 3:
        second = "/three";
        break;
      case 4:
        second = "/four";
        break;
      default:
        second = "/any";
    }
    subs_[7] = nh_.subscribe(first, 1, onMessage);  // expect: subscriber /two
    subs_[8] = nh_.subscribe(second, 1, onMessage);  // expect: subscriber /any
  }

  void chooseSide()
  {
    std::string name = "/start";
    int side = private_nh_.param("side", 0);  // expect: param ~side = 0
    switch (side)
    {
      case LEFT:
        name = "/left";  // the values of enumerators are not compared
        break;
      case RIGHT:
        name = "/right";
        break;
    }
    // expect: subscriber /start
    // expect: subscriber /left
    subs_[9] = nh_.subscribe(name, 1, onMessage);  // expect: subscriber /right
  }

  void choose()
  {
    bool use_a, use_b;
    int count, raised, limit = 5;
    private_nh_.param("use_a", use_a, false);  // expect: param ~use_a = false
    private_nh_.param("use_b", use_b, true);  // expect: param ~use_b = true
    private_nh_.param("count", count, twice(limit));  // expect: param ~count
    private_nh_.param("raised", raised, 1);  // expect: param ~raised = 1
    limit = twice(raised);
    std::string name = "/neither";
    if (use_a || debug_)
    {
      name = "/a_or_debug";
      if (count == 10)
        name = "/a_and_ten";
    }
    if (!use_b)
    {
      subs_[10] = nh_.subscribe(name, 1, onMessage);  // expect: subscriber /neither
      return;
    }
    if (use_b && raised == 1)
      name += "/raised";
    if (rate_ > 5 && use_b)
      name += "/fast";
    // expect: subscriber /neither/raised
    // expect: subscriber /neither/fast
    // expect: subscriber /neither
    subs_[11] = nh_.subscribe(name, 1, onMessage);  // expect: subscriber /neither/raised/fast
  }

  ros::NodeHandle nh_, private_nh_;
  std::string scan_;
  bool debug_;
  double rate_;
  ros::Subscriber subs_[12];
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  Node node;
  ros::spin();
}
