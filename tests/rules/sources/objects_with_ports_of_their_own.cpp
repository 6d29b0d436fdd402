// Objects of one class, each with ports and a timer of its own: what it sends, and how often, hangs on the object.
//
// expect: round_always(_, [_, "publisher", "left/speed"]), round_always(_, [_, "publisher", "right/speed"])
// expect: period_for_sink(_, [_, "publisher", "left/speed"], "0.1", 1, ""), period_for_sink(_, [_, "publisher", "right/speed"], "0.2", 1, "")
// expect: 2 = count : { period_for_sink(_, _, _, _, _) }, 1 = count : { round_of_each(_) }
// expect-only: reactive * -> *
// expect: reactive left/turns -> left/taken must
// expect: reactive right/turns -> right/taken must
// expect: reactive stop -> left/taken must
// expect: 1 = count : { round_always(_, [_, "publisher", "front"]) }, 1 = count : { round_sends(_, [_, "publisher", "front"], "1") }
// expect: round_always(_, [_, "publisher", "rear"]), round_sends(_, [_, "publisher", "rear"], "1")
// expect: round_always(_, [_, "publisher", "first"]), 0 = count : { round_always(_, [_, "publisher", "second"]) }
// expect: round_always(_, [_, "publisher", "both"]), round_sends(_, [_, "publisher", "both"], "2")
// expect: bound_to_object(_, _), 0 = count : { sends_periodically(_, [_, "publisher", "idle"], _) }, round_always(_, [_, "publisher", "driven"])
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <ros/ros.h>
#include <std_msgs/Empty.h>

class Wheel {
public:
  Wheel(ros::NodeHandle & nh, const std::string & side, double period) : side_(side)
  {
    speed_ = nh.advertise<std_msgs::Empty>(side_ + "/speed", 1);
    taken_ = nh.advertise<std_msgs::Empty>(side_ + "/taken", 1);
    turns_ = nh.subscribe(side_ + "/turns", 1, &Wheel::onTurns, this);
    timer_ = nh.createTimer(ros::Duration(period), &Wheel::tick, this);
  }
  void stop() { taken_.publish(std_msgs::Empty()); }

private:
  void onTurns(const std_msgs::Empty &) { stop(); }
  void tick(const ros::TimerEvent &) { speed_.publish(std_msgs::Empty()); }

  std::string side_;
  ros::Publisher speed_, taken_;
  ros::Subscriber turns_;
  ros::Timer timer_;
};

class Sensor {
public:
  Sensor(ros::NodeHandle & nh, const std::string & name) { pub_ = nh.advertise<std_msgs::Empty>(name, 1); }
  void sample() { pub_.publish(std_msgs::Empty()); }
  void sampleOn(const ros::TimerEvent &) { sample(); }

private:
  ros::Publisher pub_;
};

class Robot {
public:
  Robot() : left_(nh_, "left", 0.1), right_(nh_, "right", 0.2), both_(nh_, "both"), idle_(nh_, "idle"), driven_(nh_, "driven")
  {
    sensors_.push_back(std::make_shared<Sensor>(nh_, "front"));
    sensors_.push_back(std::make_shared<Sensor>(nh_, "rear"));
    by_name_["first"] = std::make_shared<Sensor>(nh_, "first");
    by_name_["second"] = std::make_shared<Sensor>(nh_, "second");
    stop_ = nh_.subscribe("stop", 1, &Robot::onStop, this);
    timer_ = nh_.createTimer(ros::Duration(1), &Robot::tick, this);
    driver_ = nh_.createTimer(ros::Duration(1), &Sensor::sampleOn, &driven_);
  }

private:
  void onStop(const std_msgs::Empty &) { left_.stop(); }
  void tick(const ros::TimerEvent &)
  {
    for (auto & sensor : sensors_) {
      sensor->sample();
    }
    by_name_["first"]->sample();
    both_.sample();
    both_.sample();
  }

  ros::NodeHandle nh_;
  Wheel left_, right_;
  Sensor both_, idle_, driven_;
  std::vector<std::shared_ptr<Sensor>> sensors_;
  std::map<std::string, std::shared_ptr<Sensor>> by_name_;
  ros::Subscriber stop_;
  ros::Timer timer_, driver_;
};

int main(int argc, char ** argv)
{
  ros::init(argc, argv, "robot");
  Robot robot;
  ros::spin();
}
