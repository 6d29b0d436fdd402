// The type of a port in a class template is the argument that a template derived from it passes on.
//
// expect: publisher said std_msgs/Bool
// expect-only: publisher
#include <ros/ros.h>
#include <std_msgs/Bool.h>

template <class Message>
class Sender {
 public:
  void start(ros::NodeHandle& nh) { pub_ = nh.advertise<Message>("said", 1); }

 private:
  ros::Publisher pub_;
};

template <class Message = std_msgs::Bool>
class Between : public Sender<Message> {};

template <class Message = std_msgs::Bool>
class Last : public Between<Message> {};

int main(int argc, char** argv) {
  ros::init(argc, argv, "sender");
  ros::NodeHandle nh;
  Last<> last;
  last.start(nh);
  ros::spin();
}
