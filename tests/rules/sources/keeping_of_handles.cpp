// Handles of roscpp that end with a function: their subscriptions, services, timers and threads end with them. Pointers, what is given away, and what main holds last.
//
// expect: ends_too_early(S, "subscription"), port([S, _, "local"])
// expect: ends_too_early(S, "subscription"), port([S, _, "image"])
// expect: ends_too_early(S, "subscription"), port([S, _, "filtered"])
// expect: ends_too_early(S, "subscription"), port([S, _, "shared"])
// expect: ends_too_early(S, "service"), port([S, _, "service"])
// expect: ends_too_early(S, "action server"), port([S, _, "act"])
// expect: ends_too_early(S, "publisher"), port([S, _, "lost"])
// expect: 1 = count : { ends_too_early(_, "broadcaster") }, 1 = count : { ends_too_early(_, "timer") }, 1 = count : { ends_too_early(_, "spinner") }
// expect: 1 = count : { ends_too_early(_, "server of parameters") }, 11 = count : { ends_too_early(_, _) }
#include <actionlib/server/simple_action_server.h>
#include <dynamic_reconfigure/Config.h>
#include <dynamic_reconfigure/server.h>
#include <image_transport/image_transport.h>
#include <message_filters/subscriber.h>
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_srvs/Trigger.h>
#include <tf2_msgs/LookupTransformAction.h>
#include <tf2_ros/transform_broadcaster.h>

using Server = actionlib::SimpleActionServer<tf2_msgs::LookupTransformAction>;

class Lamp {
public:
  explicit Lamp(ros::NodeHandle& nh) : nh_(nh), transport_(nh) {
    ros::Subscriber sub = nh_.subscribe("local", 1, &Lamp::onSwitch, this);
    image_transport::Subscriber image = transport_.subscribe("image", 1, &Lamp::onImage, this);
    message_filters::Subscriber<std_msgs::Bool> filtered(nh_, "filtered", 1);
    filtered.registerCallback(&Lamp::onSwitch, this);
    std::shared_ptr<message_filters::Subscriber<std_msgs::Bool>> shared(new message_filters::Subscriber<std_msgs::Bool>(nh_, "shared", 1));
    shared->registerCallback(&Lamp::onSwitch, this);
    nh_.advertiseService("service", &Lamp::onAsk, this);
    ros::Timer timer = nh_.createTimer(ros::Duration(1), &Lamp::onTimer, this);
    timer.start();
    Server server(nh_, "act", [](const tf2_msgs::LookupTransformGoalConstPtr&) {}, false);
    server.start();
    dynamic_reconfigure::Server<dynamic_reconfigure::Config> parameters;
    ros::AsyncSpinner spinner(2);
    spinner.start();
    // a pointer, a part of something that lasts, and one that a function is given
    auto* pointer = new message_filters::Subscriber<std_msgs::Bool>(nh_, "pointer", 1);
    pointer->registerCallback(&Lamp::onSwitch, this);
    subs_.push_back(nh_.subscribe("pushed", 1, &Lamp::onSwitch, this));
    auto given = nh_.subscribe("given", 1, &Lamp::onSwitch, this);
    keep(given);
    sub_ = nh_.subscribe("member", 1, &Lamp::onSwitch, this);
    timer_ = nh_.createTimer(ros::Duration(1), &Lamp::onTimer, this);
  }

  bool first() {
    ros::Subscriber sub = nh_.subscribe("awaited", 1, &Lamp::onSwitch, this);
    for (int i = 0; i < 10; i++) {
      ros::Duration(0.1).sleep();
      ros::spinOnce();
    }
    return on_;
  }

  void later() {
    ros::Subscriber sub = nh_.subscribe("helped", 1, &Lamp::onSwitch, this);
    let();
  }

private:
  void let() { ros::spinOnce(); }
  void keep(const ros::Subscriber& sub) { subs_.push_back(sub); }
  void onSwitch(const std_msgs::Bool& message) { on_ = message.data; }
  void onImage(const sensor_msgs::ImageConstPtr&) { on_ = true; }
  bool onAsk(std_srvs::Trigger::Request&, std_srvs::Trigger::Response&) { return on_; }
  void onTimer(const ros::TimerEvent&) {
    ros::Publisher lost = nh_.advertise<std_msgs::Bool>("lost", 1);
    lost.publish(std_msgs::Bool());
    tf2_ros::TransformBroadcaster broadcaster;
    broadcaster.sendTransform(geometry_msgs::TransformStamped());
    // latched, and one that all calls share
    ros::Publisher latched = nh_.advertise<std_msgs::Bool>("latched", 1, true);
    latched.publish(std_msgs::Bool());
    static ros::Publisher kept = nh_.advertise<std_msgs::Bool>("kept", 1);
    kept.publish(std_msgs::Bool());
  }

  ros::NodeHandle nh_;
  image_transport::ImageTransport transport_;
  ros::Subscriber sub_;
  ros::Timer timer_;
  std::vector<ros::Subscriber> subs_;
  bool on_ = false;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "lamp");
  ros::NodeHandle nh;
  Lamp lamp(nh);
  ros::Subscriber sub = nh.subscribe<std_msgs::Bool>("of_main", 1, [](const std_msgs::Bool::ConstPtr&) {});
  ros::AsyncSpinner spinner(2);
  spinner.start();
  lamp.first();
  lamp.later();
  ros::waitForShutdown();
}
