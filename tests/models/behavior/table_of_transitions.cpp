// Transitions in a constant table that is searched: one for each row that the event fits.
//
// expect: reactive /brake -> /torque may [gear_ == Gear::DRIVE]
// expect: reactive /up -> /torque may [gear_ == Gear::DRIVE]
// expect: state Gearbox::gear_ = Gear::PARK
// expect: transition Gearbox::gear_ . None on /brake [t.from == gear_ && t.event == event] := Gear::NEUTRAL
// expect: transition Gearbox::gear_ . None on /up [t.from == gear_ && t.event == event] := Gear::DRIVE
// expect: transition Gearbox::gear_ . None on /up [t.from == gear_ && t.event == event] := Gear::DRIVE
// normal: reactive /brake -> /torque [gear_ == Gear::DRIVE]
// normal: reactive /up -> /torque [gear_ == Gear::DRIVE]
// normal: transition Gearbox::gear_ on /brake [gear_ == Gear::PARK]
// normal: transition Gearbox::gear_ on /up [gear_ == Gear::DRIVE]
// normal: transition Gearbox::gear_ on /up [gear_ == Gear::NEUTRAL]
#include <ros/ros.h>
#include <std_msgs/Empty.h>

enum class Gear { PARK, NEUTRAL, DRIVE };
enum class Event { BRAKE, UP, DOWN };

struct Transition
{
  Gear from;
  Event event;
  Gear to;
};

static const Transition TABLE[] = {
  {Gear::PARK, Event::BRAKE, Gear::NEUTRAL},
  {Gear::NEUTRAL, Event::UP, Gear::DRIVE},
  {Gear::DRIVE, Event::UP, Gear::DRIVE},
  {Gear::DRIVE, Event::DOWN, Gear::NEUTRAL},
};

class Gearbox
{
public:
  Gearbox()
  {
    pub_ = nh_.advertise<std_msgs::Empty>("/torque", 1);
    brake_ = nh_.subscribe("/brake", 1, &Gearbox::onBrake, this);
    up_ = nh_.subscribe("/up", 1, &Gearbox::onUp, this);
  }

private:
  void onBrake(const std_msgs::Empty&) { process(Event::BRAKE); }
  void onUp(const std_msgs::Empty&) { process(Event::UP); }

  void process(Event event)
  {
    if (gear_ == Gear::DRIVE)
      pub_.publish(std_msgs::Empty());
    for (const auto& t : TABLE)
    {
      if (t.from == gear_ && t.event == event)
      {
        gear_ = t.to;
        return;
      }
    }
  }

  ros::NodeHandle nh_;
  ros::Publisher pub_;
  ros::Subscriber brake_, up_;
  Gear gear_ = Gear::PARK;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  Gearbox gearbox;
  ros::spin();
}
