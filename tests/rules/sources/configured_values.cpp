// Values that parameters give: of a member that decides, about a port as well, of one that a counter begins with, of a local variable of main.
//
// expect: keeps_value_of("active_", "~active")
// expect: keeps_value_of("skip_", "~skip")
// expect: keeps_value_of("quiet", "~quiet")
// expect: keeps_value_of("loud", "~loud")
// expect: keeps_value_of("draws_", "~draws")
// expect: keeps_value_of("listens_", "~listens")
// expect: N = count : { keeps_value_of(_, _) }, N = 6
#include <ros/ros.h>
#include <std_msgs/Empty.h>

class Filter {
 public:
  Filter() : pnh_("~"), left_(0) {
    pnh_.param("active", active_, true);
    pnh_.param("skip", skip_, 3);
    pnh_.param("shared", shared, false);
    left_ = skip_;
    if (!pnh_.getParam("draws", draws_)) draws_ = true;
    pnh_.param("listens", listens_, false);
    if (!pnh_.getParam("guesses", guesses_)) draws_too_ = true;
    if (draws_ && guesses_) drawn_ = nh_.advertise<std_msgs::Empty>("drawn", 1);
    if (!listens_) other_ = nh_.subscribe("other", 1, &Filter::onIn, this);
    if (nh_.ok()) guesses_ = false;
    out_ = nh_.advertise<std_msgs::Empty>("out", 1);
    in_ = nh_.subscribe("in", 1, &Filter::onIn, this);
  }

 private:
  void onIn(const std_msgs::Empty& msg) {
    if (!active_ || shared) return;
    if (--left_ > 0) return;
    left_ = skip_;
    out_.publish(msg);
  }

  ros::NodeHandle nh_, pnh_;
  ros::Publisher out_, drawn_;
  ros::Subscriber in_, other_;
  bool active_, shared, draws_, draws_too_, listens_, guesses_;
  int skip_, left_;
};

struct Other {
  void onStart(const std_msgs::Empty&) { shared = !shared; }
  bool shared = false;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "filter");
  Filter filter;
  Other other;
  ros::NodeHandle nh("~");
  ros::Subscriber start = nh.subscribe("start", 1, &Other::onStart, &other);
  bool quiet = false;
  nh.getParam("quiet", quiet);
  bool changed = false;
  nh.getParam("changed", changed);
  changed = changed && quiet;
  bool loud = nh.param("loud", false);
  bool seldom = false;
  if (argc > 1) nh.getParam("seldom", seldom);
  bool handed = false;
  nh.getParam("handed", handed);
  nh.getParam("handed_too", handed);
  ros::Publisher line = nh.advertise<std_msgs::Empty>("line", 1);
  ros::Rate rate(5);
  while (ros::ok()) {
    if (!quiet && !changed && !seldom && !handed && !loud) line.publish(std_msgs::Empty());
    ros::spinOnce();
    rate.sleep();
  }
}
