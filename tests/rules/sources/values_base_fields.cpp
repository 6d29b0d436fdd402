// A base class keeps the name of a topic; each class that derives from it gives it another one, and makes its port by itself.
//
// expect: subscriber cmd_vel geometry_msgs/Twist
// expect: subscriber goal geometry_msgs/PoseStamped
// expect: publisher info std_msgs/String
// expect: publisher plain std_msgs/String
// expect: publisher derived std_msgs/Bool
// expect: publisher again std_msgs/Bool
// expect-not: port([_, "subscriber", Name]), port_type([_, "subscriber", Name], "geometry_msgs/PoseStamped"), Name != "goal"
// expect: 2 = count : { port([_, "subscriber", _]) }
#include <memory>
#include <string>
#include <ros/ros.h>
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/Twist.h>
#include <std_msgs/Bool.h>
#include <std_msgs/String.h>

class Reader
{
public:
  explicit Reader(const std::string & topic) : topic_(topic) {}
  virtual ~Reader() {}
  virtual void reset(ros::NodeHandle & nh) = 0;

protected:
  std::string topic_;
  ros::Subscriber sub_;
};

class Teleop : public Reader
{
public:
  explicit Teleop(const std::string & name) : Reader(name) {}
  void reset(ros::NodeHandle & nh) override {sub_ = nh.subscribe(topic_, 10, &Teleop::callback, this);}
  void callback(const geometry_msgs::TwistConstPtr &) {}
};

class Goal : public Reader
{
public:
  explicit Goal(const std::string & name) : Reader(name) {}
  void reset(ros::NodeHandle & nh) override {sub_ = nh.subscribe(topic_, 10, &Goal::callback, this);}
  void callback(const geometry_msgs::PoseStampedConstPtr &) {}
};

template <class T>
class Writer
{
public:
  explicit Writer(const std::string & topic) : topic_(topic) {}
  virtual ~Writer() {}
  virtual void reset(ros::NodeHandle & nh) {pub_ = nh.advertise<T>(topic_, 10);}

protected:
  std::string topic_;
  ros::Publisher pub_;
};

class Info : public Writer<std_msgs::String>
{
public:
  explicit Info(const std::string & topic) : Writer(topic) {}
  void reset(ros::NodeHandle & nh) override {pub_ = nh.advertise<std_msgs::String>(topic_, 1, true);}
};

// a class between: its objects are those of the class below it, too
class Between
{
public:
  explicit Between(const std::string & topic) {topic_ = topic;}
  virtual ~Between() {}
  void make(ros::NodeHandle & nh) {pub_ = nh.advertise<std_msgs::Bool>(topic_, 1);}

protected:
  std::string topic_;
  ros::Publisher pub_;
};

class Middle : public Between
{
public:
  explicit Middle(const std::string & topic) : Between(topic) {}
  void make_again(ros::NodeHandle & nh) {again_ = nh.advertise<std_msgs::Bool>("again", 1);}

private:
  ros::Publisher again_;
};

class Last : public Middle
{
public:
  Last() : Middle("derived") {}
};

int main(int argc, char ** argv)
{
  ros::init(argc, argv, "fields");
  ros::NodeHandle nh;
  Teleop teleop("cmd_vel");
  Goal goal("goal");
  Info info("info");
  Writer<std_msgs::String> plain("plain");
  Last last;
  teleop.reset(nh);
  goal.reset(nh);
  info.reset(nh);
  plain.reset(nh);
  last.make(nh);
  last.make_again(nh);
  ros::spin();
}
