// A method that nobody calls, of an object that is made: nothing that it would do is done.
//
// expect: publisher /kept std_msgs/Int32
// expect-only: *
// expect-not: node_name("never"); timer_callback(_, _); sets_off(_); starts_thread(_, _); sends(_, _); periodic(_, _, _); sleep(_, _)
// expect-not: queue_served(_, "", "2"); timed_loop(_, _); activity(_, "signal"); activity(_, "thread"); waits_for(_, _); port_callback(_, _); _lookup_argument(_, _, _)
// expect-not: state_variable(_); changes(_, _, _); transition(_, _, _); runs_later(_, _); parameter_access(_, _, _); hidden_site(_, "ros::init")
// expect-not: calls(_, F), function_name(F, "Kept::helper"), reachable(F)
// expect: Count = count : { component_middleware(_) }, Count = 1
// expect: 5 = count : { class_constructed(_) }
// expect-not: period_amount(_, _, _)
#include <csignal>
#include <map>
#include <ros/ros.h>
#include <std_msgs/Int32.h>
#include <string>
#include <tf/transform_listener.h>
#include <thread>

class Kept
{
public:
  Kept()
  {
    pub_ = nh_.advertise<std_msgs::Int32>("/kept", 1);
  }

  void unused(int argc, char** argv)
  {
    std::map<std::string, std::string> remappings;
    remappings["from"] = "to";
    ros::init(remappings, "never");
    signal(SIGINT, onSignal);
    ros::Publisher other = nh_.advertise<std_msgs::Int32>("/never", 1);
    sub_ = nh_.subscribe("/never_read", 1, &Kept::onNumber, this);
    timer_ = nh_.createTimer(ros::Duration(1.0), &Kept::onTimer, this);
    ros::service::waitForService("/never_waited");
    ros::topic::waitForMessage<std_msgs::Int32>("/never_awaited", nh_);
    nh_.param("never", limit_, 3);
    std::thread worker(&Kept::helper, this);
    ros::AsyncSpinner spinner(2);
    spinner.start();
    tf::StampedTransform transform;
    listener_->lookupTransform("map", ros::Time(0), "base", ros::Time(0), "odom", transform);
    ros::Rate rate(10);
    while (ros::ok())
    {
      if (count_ > limit_)
        pub_.publish(std_msgs::Int32());
      ++count_;
      helper();
      ros::spinOnce();
      rate.sleep();
    }
  }

private:
  static void onSignal(int) {}

  void onNumber(const std_msgs::Int32& number)
  {
    count_ = number.data;
  }

  void onTimer(const ros::TimerEvent&)
  {
    timer_.stop();
  }

  void helper()
  {
    if (count_ > 2)
      pub_.publish(std_msgs::Int32());
  }

  ros::NodeHandle nh_;
  ros::Publisher pub_;
  ros::Subscriber sub_;
  ros::Timer timer_;
  tf::TransformListener* listener_ = nullptr;
  int limit_ = 0, count_ = 0;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "kept");
  Kept kept;
  ros::spin();
}
