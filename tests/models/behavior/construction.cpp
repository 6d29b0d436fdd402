// What a constructor gives to its own object is how that begins, also when it is made at run time; what it gives to others changes them.
#include <boost/shared_ptr.hpp>
#include <ros/ros.h>
#include <std_msgs/Int32.h>

ros::Publisher out;
int made = 0;

class Base
{
public:
  Base() { limit_ = 3; }
  int limit_;
};
class Track : public Base
{
public:
  explicit Track(int first)
  {
    count_ = first;
    limit_ = 10;
    ++made;
  }
  void add(int value)
  {
    if (count_ < limit_)
      count_ += value;
  }
  bool full() const { return count_ >= limit_; }

private:
  int count_;
};

boost::shared_ptr<Track> track;

void onStart(const std_msgs::Int32& m) { track.reset(new Track(m.data)); }
void onValue(const std_msgs::Int32& m)
{
  if (!track || made > 5)
    return;
  track->add(m.data);
  if (track->full())
    out.publish(m);
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "n");
  ros::NodeHandle nh;
  out = nh.advertise<std_msgs::Int32>("out", 1);
  ros::Subscriber s1 = nh.subscribe("start", 1, onStart);
  ros::Subscriber s2 = nh.subscribe("value", 1, onValue);
  ros::spin();
}
// expect: reactive value -> out may [!(!track || made > 5) && track->full()]
// expect: config Base::limit_ = 10 None
// expect: state ::made = 0
// expect: state ::track = None
// expect: state Track::count_ = first
// expect: transition ::made . None on start [] := ++made
// expect: transition ::track . None on start [] := track.reset(new Track(m.data))
// expect: transition Track::count_ . None on value [!(!track || made > 5) && count_ < limit_] := count_ + value
