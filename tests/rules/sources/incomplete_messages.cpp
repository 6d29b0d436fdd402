// Messages that are sent without a stamp or a frame: made, filled and sent in one function. What sets the header, is given the message, copies it from another one or keeps it elsewhere, silences.
//
// expect: 5 = count : { sent_without(_, _, _) }
// expect: sent_without(_, [_, _, "set"], "header.frame_id")
// expect: sent_without(_, [_, _, "plain"], "header")
// expect: sent_without(_, [_, _, "shared"], "header")
// expect: sent_without(_, [_, _, "pointer"], "header")
// expect: sent_without(_, [_, _, "made"], "header")
#include <boost/make_shared.hpp>
#include <ros/ros.h>
#include <sensor_msgs/JointState.h>
#include <sensor_msgs/Range.h>
#include <std_msgs/Float64.h>
#include <trajectory_msgs/JointTrajectory.h>

void stamp(sensor_msgs::Range& range) { range.header.stamp = ros::Time::now(); }

class Sensors {
public:
  Sensors() {
    plain_ = nh_.advertise<sensor_msgs::Range>("plain", 1);
    shared_ = nh_.advertise<sensor_msgs::JointState>("shared", 1);
    pointer_ = nh_.advertise<sensor_msgs::Range>("pointer", 1);
    made_ = nh_.advertise<sensor_msgs::Range>("made", 1);
    set_ = nh_.advertise<sensor_msgs::Range>("set", 1);
    whole_ = nh_.advertise<sensor_msgs::Range>("whole", 1);
    given_ = nh_.advertise<sensor_msgs::Range>("given", 1);
    copied_ = nh_.advertise<sensor_msgs::Range>("copied", 1);
    replaced_ = nh_.advertise<sensor_msgs::Range>("replaced", 1);
    member_ = nh_.advertise<sensor_msgs::Range>("member", 1);
    referred_ = nh_.advertise<sensor_msgs::Range>("referred", 1);
    captured_ = nh_.advertise<sensor_msgs::Range>("captured", 1);
    trajectory_ = nh_.advertise<trajectory_msgs::JointTrajectory>("trajectory", 1);
    sub_ = nh_.subscribe("distance", 1, &Sensors::onDistance, this);
    range_sub_ = nh_.subscribe("range", 1, &Sensors::onRange, this);
  }

private:
  void onDistance(const std_msgs::Float64& distance) {
    sensor_msgs::Range plain;
    plain.range = distance.data;
    plain_.publish(plain);
    auto shared = boost::make_shared<sensor_msgs::JointState>();
    shared->position.push_back(distance.data);
    shared_.publish(shared);
    sensor_msgs::RangePtr pointer(new sensor_msgs::Range());
    pointer->range = distance.data;
    pointer_.publish(pointer);
    sensor_msgs::Range made = sensor_msgs::Range();
    made.range = distance.data;
    made_.publish(made);
    sensor_msgs::Range set;
    set.header.stamp = ros::Time::now();
    set_.publish(set);
    sensor_msgs::Range given;
    stamp(given);
    given_.publish(given);
    sensor_msgs::Range captured;
    auto fill = [&captured] { captured.header.stamp = ros::Time::now(); };
    fill();
    captured_.publish(captured);
    sensor_msgs::Range referred;
    sensor_msgs::Range& other = referred;
    stamp(other);
    referred_.publish(referred);
    message_.range = distance.data;
    member_.publish(message_);
    trajectory_msgs::JointTrajectory trajectory;
    trajectory.joint_names.push_back("elbow");
    trajectory_.publish(trajectory);
  }
  void onRange(const sensor_msgs::Range& range) {
    sensor_msgs::Range whole;
    whole.header = range.header;
    whole_.publish(whole);
    sensor_msgs::Range copied = range;
    copied.range = 1;
    copied_.publish(copied);
    sensor_msgs::Range replaced;
    replaced = range;
    replaced_.publish(replaced);
  }

  ros::NodeHandle nh_;
  ros::Publisher plain_, shared_, pointer_, made_, set_, whole_, given_, copied_, replaced_, member_, referred_, captured_, trajectory_;
  ros::Subscriber sub_, range_sub_;
  sensor_msgs::Range message_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "sensors");
  Sensors sensors;
  ros::spin();
}
