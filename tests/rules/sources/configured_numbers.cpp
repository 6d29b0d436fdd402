// Constants that state variables are compared with or given; not a variable that changes, nor a name that two have.
//
// expect: names_number("MOST", "3")
// expect: names_number("EVERY", "4")
// expect: names_number("kAll", "5")
// expect: names_number("START", "9")
// expect: names_number("size_", "6")
// expect: N = count : { names_number(_, _) }, N = 5
#include <vector>
#include <ros/ros.h>
#include <std_msgs/Int32.h>

static int g_limit = 7;
const int TWICE = 2;

struct Other {
  static const int TWICE = 6;
};

class Counter {
  static const int MOST = 3;
  static constexpr int EVERY = 4;
  const unsigned kAll = 5;
  static const int START = 9;
  static const int UNUSED = 8;
  const int size_;

 public:
  Counter() : size_(6) {
    out_ = nh_.advertise<std_msgs::Int32>("out", 1);
    in_ = nh_.subscribe("in", 1, &Counter::onIn, this);
    limit_ = nh_.subscribe("limit", 1, &Counter::onLimit, this);
  }

 private:
  void onLimit(const std_msgs::Int32& msg) { g_limit = msg.data; }
  void onIn(const std_msgs::Int32& msg) {
    all_.push_back(msg.data);
    if (++n_ >= MOST && ++m_ % EVERY == 0 && all_.size() < kAll && n_ < g_limit && n_ > TWICE && n_ != size_) {
      n_ = START;
      out_.publish(msg);
    }
  }

  ros::NodeHandle nh_;
  ros::Publisher out_;
  ros::Subscriber in_, limit_;
  int n_ = 0, m_ = 0;
  std::vector<int> all_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "counter");
  Counter counter;
  ros::spin();
}
