// Buffers and listeners that a callback makes and asks at once; not those that it waits for, that are kept, or that are asked later.
//
// expect: 2 = count : { misused(_, "buffer just made", _) }
// expect: misused(as(C, Node), "buffer just made", _), location(C, _, 26, _)
// expect: misused(as(C, Node), "buffer just made", _), location(C, _, 33, _)
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <tf/transform_listener.h>
#include <tf2_ros/transform_listener.h>

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
  }

  void onMade(const std_msgs::Empty::ConstPtr&) {
    tf2_ros::Buffer buffer;
    tf2_ros::TransformListener listener(buffer);
    buffer.lookupTransform("map", "base", ros::Time(0));
  }

  void onOld(const std_msgs::Empty::ConstPtr&) {
    tf::TransformListener listener;
    tf::StampedTransform transform;

    listener.lookupTransform("map", "base", ros::Time(0), transform);
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

private:
  ros::NodeHandle nh_;
  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_;
  ros::Subscriber made_, old_, waited_, slept_, again_, timeout_, kept_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "place");
  Place place;
  tf2_ros::Buffer buffer;
  tf2_ros::TransformListener listener(buffer);
  buffer.lookupTransform("map", "base", ros::Time(0));
  ros::spin();
}
