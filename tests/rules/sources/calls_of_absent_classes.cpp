// A class that no header brings runs a method in a thread, as the API says of its own method of that name: not of a method of whatever is not known.
//
// expect: publisher beat
// expect: state Beater::beats_ = 0
// expect: transition Beater::beats_ = beats_++ trigger=thread
#include <absent/threads.hpp>
#include <ecl/threads.hpp>
#include <ros/ros.h>
#include <std_msgs/Bool.h>

class Beater
{
public:
  void init()
  {
    beat_ = nh_.advertise<std_msgs::Bool>("beat", 1);
    absent::Engine engine;
    engine.start(1);
    absent::make().start(2);
    thread_.start(&Beater::loop, *this);
  }

private:
  void loop()
  {
    while (ros::ok()) {
      if (beats_ < 10)
        beat_.publish(std_msgs::Bool());
      beats_++;
    }
  }

  ros::NodeHandle nh_;
  ros::Publisher beat_;
  int beats_ = 0;
  ecl::Thread thread_;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "beater");
  Beater beater;
  beater.init();
  ros::spin();
}
