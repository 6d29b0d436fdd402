// Subscriptions and timers that end before they can do anything set off nothing; what is handed on, waited for or kept does.
// expect-not: reactive gone -> *
// expect-not: reactive thrown_away -> *
// expect-not: reactive made_by_gone -> *
// expect-not: transition g_seen
// expect-not: periodic never
// expect: reactive kept -> out must
// expect: reactive stored -> out must
// expect: reactive returned -> out must
// expect: reactive meanwhile -> out must
// expect: periodic always 10 Hz
// expect: sends_nothing([_, "publisher", "answer"])
// expect: sends_nothing([_, "publisher", "never"])
// expect-not: sends_nothing([_, "publisher", "out"])
// expect-not: sends_nothing([_, "publisher", "elsewhere"])
// expect: given_away([_, "publisher", "elsewhere"])
// expect: unheard([_, "subscriber", "gone"], "what holds it goes out of scope")
// expect-not: unheard([_, "subscriber", "kept"], _)
// expect-not: unheard([_, "subscriber", "stored"], _)
// expect-not: unsteady(_, _)
#include <ros/ros.h>
#include <std_msgs/Int32.h>
#include <vector>

#include "elsewhere.h"

static bool g_seen = false;

class Lives
{
public:
  Lives()
  {
    out_ = nh_.advertise<std_msgs::Int32>("out", 1);
    answer_ = nh_.advertise<std_msgs::Int32>("answer", 1);
    never_ = nh_.advertise<std_msgs::Int32>("never", 1);
    always_ = nh_.advertise<std_msgs::Int32>("always", 1);
    elsewhere_ = nh_.advertise<std_msgs::Int32>("elsewhere", 1);
    elsewhere::keep(elsewhere_);
    lose();
    nh_.subscribe("thrown_away", 1, &Lives::onGone, this);
    ros::Subscriber kept = nh_.subscribe("kept", 1, &Lives::onKept, this);
    kept_ = kept;
    ros::Subscriber stored = nh_.subscribe("stored", 1, &Lives::onKept, this);
    all_.push_back(stored);
    ros::Timer always = nh_.createTimer(ros::Duration(0.1), &Lives::onAlways, this);
    timer_ = always;
    returned_ = open();
    wait();
  }

private:
  void lose()
  {
    ros::Subscriber gone = nh_.subscribe("gone", 1, &Lives::onGone, this);
    ros::Timer never = nh_.createTimer(ros::Duration(0.1), &Lives::onNever, this);
  }
  ros::Subscriber open()
  {
    ros::Subscriber made = nh_.subscribe("returned", 1, &Lives::onKept, this);
    return made;
  }
  void wait()
  {
    ros::Subscriber meanwhile = nh_.subscribe("meanwhile", 1, &Lives::onKept, this);
    ros::spinOnce();
  }
  void onGone(const std_msgs::Int32& message)
  {
    answer(message);
    late_ = nh_.subscribe("made_by_gone", 1, &Lives::onLate, this);
  }
  void answer(const std_msgs::Int32& message)
  {
    if (g_seen)
      answer_.publish(message);
    g_seen = !g_seen;
  }
  void onLate(const std_msgs::Int32& message) { answer_.publish(message); }
  void onNever(const ros::TimerEvent&) { never_.publish(std_msgs::Int32()); }
  void onKept(const std_msgs::Int32& message) { out_.publish(message); }
  void onAlways(const ros::TimerEvent&) { always_.publish(std_msgs::Int32()); }

  ros::NodeHandle nh_;
  ros::Publisher out_, answer_, never_, always_, elsewhere_;
  ros::Subscriber kept_, returned_, late_;
  ros::Timer timer_;
  std::vector<ros::Subscriber> all_;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "lifetimes");
  Lives lives;
  ros::spin();
}
