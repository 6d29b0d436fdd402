// A switch decides whether a loop sends; what it sends is a constant, of which a flag that is set under a condition tells.
//
// expect: port_flow([_, _, "/enable"], [_, _, "/beat"], "control", "deferred")
// expect: port_flow([_, _, "/level"], [_, _, "/beat"], "control", "deferred")
// expect: flow_filter([_, _, "/enable"], [_, _, "/beat"], "Beat::enabled_")
// expect: round_sends(_, [_, _, "/beat"], "1")
// expect-not: round_always(_, _)
// expect-not: sent_untimed(_)
// expect: Count = count : { port_flow(_, _, _, _) }, Count = 2
// expect: N = count : { _goes_back(_, _) }, N = 1
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_msgs/Int32.h>

class Beat
{
public:
  Beat()
  {
    enable_ = nh_.subscribe("/enable", 1, &Beat::onEnable, this);
    level_sub_ = nh_.subscribe("/level", 1, &Beat::onLevel, this);
    pub_ = nh_.advertise<std_msgs::Bool>("/beat", 1);
  }
  void run()
  {
    ros::Rate rate(10);
    while (ros::ok())
    {
      ros::spinOnce();
      bool high = false;
      if (level_ > 3)
        high = true;
      std_msgs::Bool beat;
      beat.data = high;
      if (enabled_)
        pub_.publish(beat);
      rate.sleep();
    }
  }

private:
  void onEnable(const std_msgs::Bool& msg) { enabled_ = msg.data; }
  void onLevel(const std_msgs::Int32& msg) { level_ = msg.data; }

  ros::NodeHandle nh_;
  ros::Subscriber enable_, level_sub_;
  ros::Publisher pub_;
  bool enabled_ = false;
  int level_ = 0;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "beat");
  Beat beat;
  beat.run();
}
