// An object that is made of what braces list has what is in them, whichever way the fields are named; one that is made empty has nothing.
//
// expect: sent_unmade(_, "spare")
// expect: Count = count : { sent_unmade(_, _) }, Count = 1
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <unordered_map>

struct Link {
  ros::Publisher publisher;
  ros::Subscriber subscriber;
};

struct Lamp {
  ros::Publisher spare;
};

class Bridge {
public:
  Bridge()
  {
    links_.emplace("left", Link{.publisher = nh_.advertise<std_msgs::Empty>("left", 1), .subscriber = {}});
    timer_ = nh_.createTimer(ros::Duration(1), &Bridge::tick, this);
  }

private:
  void tick(const ros::TimerEvent &)
  {
    links_.at("left").publisher.publish(std_msgs::Empty());
    lamp_.spare.publish(std_msgs::Empty());
  }

  ros::NodeHandle nh_;
  std::unordered_map<std::string, Link> links_;
  Lamp lamp_;
  ros::Timer timer_;
};

int main(int argc, char ** argv)
{
  ros::init(argc, argv, "bridge");
  Bridge bridge;
  ros::spin();
}
