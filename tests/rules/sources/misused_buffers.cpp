// Buffers and listeners that a callback makes and asks at once; not those that it waits for, that are kept or filled by hand, or that are asked later, nor what looks up within another call.
//
// expect: 5 = count : { misused(_, "buffer just made", _) }
// expect: misused(as(C, Node), "buffer just made", _), expr_text(C, "buffer.lookupTransform(\"map\", \"made\", ros::Time(0))")
// expect: misused(as(C, Node), "buffer just made", _), expr_text(C, "listener.lookupTransform(\"map\", \"old\", ros::Time(0), transform)")
// expect: misused(as(C, Node), "buffer just made", _), expr_text(C, "buffer.lookupTransform(\"map\", \"helper\", ros::Time(0))")
// expect: misused(as(C, Node), "buffer just made", _), expr_text(C, "buffer.lookupTransform(\"map\", \"often\", ros::Time(0))")
// expect: misused(as(C, Node), "buffer just made", _), expr_text(C, "buffer.lookupTransform(\"map\", \"timer\", ros::Time(0))")
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/TransformStamped.h>
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <tf/transform_listener.h>
#include <tf2_ros/transform_listener.h>
#include <memory>

struct Cache {
  void lookupTransform(const std::string& target, const std::string& source, const ros::Time& time) { last_ = target + source; }
  std::string last_;
};

void ask_in_loop(ros::Publisher& pub) {
  tf2_ros::Buffer buffer;
  tf2_ros::TransformListener listener(buffer);
  buffer.lookupTransform("map", "loop", ros::Time(0));
  pub.publish(std_msgs::Empty());
}

class Place {
public:
  Place() : listener_(buffer_) {
    made_ = nh_.subscribe("made", 1, &Place::onMade, this);
    old_ = nh_.subscribe("old", 1, &Place::onOld, this);
    waited_ = nh_.subscribe("waited", 1, &Place::onWaited, this);
    slept_ = nh_.subscribe("slept", 1, &Place::onSlept, this);
    again_ = nh_.subscribe("again", 1, &Place::onAgain, this);
    timeout_ = nh_.subscribe("timeout", 1, &Place::onTimeout, this);
    kept_ = nh_.subscribe("kept", 1, &Place::onKept, this);
    others_ = nh_.subscribe("others", 1, &Place::onOthers, this);
    never_ = nh_.subscribe("never", 1, &Place::onNever, this);
    later_ = nh_.subscribe("later", 1, &Place::onLater, this);
    through_ = nh_.subscribe("through", 1, &Place::onThrough, this);
    filled_ = nh_.subscribe("filled", 1, &Place::onFilled, this);
    own_ = nh_.subscribe("own", 1, &Place::onOwn, this);
    pub_ = nh_.advertise<std_msgs::Empty>("asked", 1);
    timer_ = nh_.createTimer(ros::Duration(1), &Place::onTimer, this);
  }

  void onMade(const std_msgs::Empty::ConstPtr&) {
    tf2_ros::Buffer buffer;
    tf2_ros::TransformListener listener(buffer);
    buffer.lookupTransform("map", "made", ros::Time(0));
  }

  void onOld(const std_msgs::Empty::ConstPtr&) {
    tf::TransformListener listener;
    tf::StampedTransform transform;

    listener.lookupTransform("map", "old", ros::Time(0), transform);
  }

  void onWaited(const std_msgs::Empty::ConstPtr&) {
    tf2_ros::Buffer buffer;
    tf2_ros::TransformListener listener(buffer);
    if (buffer.canTransform("map", "base", ros::Time(0), ros::Duration(5)))
      buffer.lookupTransform("map", "base", ros::Time(0));
  }

  void onSlept(const std_msgs::Empty::ConstPtr&) {
    tf2_ros::Buffer buffer;
    tf2_ros::TransformListener listener(buffer);
    ros::Duration(2).sleep();
    buffer.lookupTransform("map", "base", ros::Time(0));
  }

  void onAgain(const std_msgs::Empty::ConstPtr&) {
    tf2_ros::Buffer buffer;
    tf2_ros::TransformListener listener(buffer);
    while (ros::ok()) {
      buffer.lookupTransform("map", "base", ros::Time(0));
    }
  }

  void onTimeout(const std_msgs::Empty::ConstPtr&) {
    tf2_ros::Buffer buffer;
    tf2_ros::TransformListener listener(buffer);
    buffer.lookupTransform("map", "base", ros::Time(0), ros::Duration(5));
  }

  void onKept(const std_msgs::Empty::ConstPtr&) {
    static tf2_ros::Buffer buffer;
    static tf2_ros::TransformListener listener(buffer);
    buffer.lookupTransform("map", "base", ros::Time(0));
    buffer_.lookupTransform("map", "base", ros::Time(0));
  }

  void onOthers(const std_msgs::Empty::ConstPtr&) {
    tf2_ros::Buffer buffer;
    tf2_ros::TransformListener listener(buffer);
    Cache cache;
    cache.lookupTransform("map", "base", ros::Time(0));
    buffer_.lookupTransform("map", "base", ros::Time(0));
    buffer.setUsingDedicatedThread(true);
    buffer.allFramesAsString();
    ask();
  }

  void ask() {
    tf2_ros::Buffer buffer;
    tf2_ros::TransformListener listener(buffer);
    buffer.lookupTransform("map", "helper", ros::Time(0));
    pub_.publish(std_msgs::Empty());
  }

  void askOften() {
    tf2_ros::Buffer buffer;
    tf2_ros::TransformListener listener(buffer);
    buffer.lookupTransform("map", "often", ros::Time(0));
    pub_.publish(std_msgs::Empty());
  }

  void onNever(const std_msgs::Empty::ConstPtr&) {
    tf2_ros::Buffer buffer;
    tf2_ros::TransformListener listener(buffer);
    return;
    buffer.lookupTransform("map", "base", ros::Time(0));
  }

  void onLater(const std_msgs::Empty::ConstPtr&) {
    auto buffer = std::make_shared<tf2_ros::Buffer>();
    auto listener = std::make_shared<tf2_ros::TransformListener>(*buffer);
    later_timer_ = nh_.createTimer(ros::Duration(1), [buffer, listener](const ros::TimerEvent&) {
      buffer->lookupTransform("map", "base", ros::Time(0));
    });
  }

  void onThrough(const geometry_msgs::PoseStamped& pose) {
    tf::TransformListener listener;
    geometry_msgs::PoseStamped out;
    listener.transformPose("map", pose, out);
  }

  void onFilled(const geometry_msgs::TransformStamped& transform) {
    tf2_ros::Buffer buffer;
    buffer.setTransform(transform, "here");
    buffer.lookupTransform("map", "base", ros::Time(0));
  }

  void onOwn(const std_msgs::Empty::ConstPtr&) {
    tf::Transformer own;
    tf::StampedTransform transform;
    own.lookupTransform("map", "base", ros::Time(0), transform);
  }

  void onTimer(const ros::TimerEvent&) {
    tf2_ros::Buffer buffer;
    tf2_ros::TransformListener listener(buffer);
    buffer.lookupTransform("map", "timer", ros::Time(0));
    askOften();
  }

private:
  ros::NodeHandle nh_;
  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_;
  ros::Subscriber made_, old_, waited_, slept_, again_, timeout_, kept_, others_, never_, later_, through_, filled_, own_;
  ros::Publisher pub_;
  ros::Timer timer_, later_timer_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "place");
  Place place;
  tf2_ros::Buffer buffer;
  tf2_ros::TransformListener listener(buffer);
  buffer.lookupTransform("map", "base", ros::Time(0));
  ros::Publisher pub = ros::NodeHandle().advertise<std_msgs::Empty>("looped", 1);
  ros::Rate rate(1);
  while (ros::ok()) {
    ask_in_loop(pub);
    ros::spinOnce();
    rate.sleep();
  }
}
