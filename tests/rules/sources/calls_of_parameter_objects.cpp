// Objects of the type that a template is made with: a singleton in a function of it, a member.
//
// expect: periodic driven 1 Hz
// expect: subscriber held_in
// expect: reactive held_in -> held_out must
#include <functional>
#include <map>
#include <ros/ros.h>
#include <std_msgs/Empty.h>

class BaseState
{
public:
  virtual void update() = 0;
  virtual void setCallback(std::function<void()> callback) = 0;
};

template <class T>
class State : public BaseState
{
public:
  virtual void update()
  {
    if (callback_)
      callback_();
  }
  virtual void setCallback(std::function<void()> callback) { callback_ = callback; }
  static BaseState *getInstance()
  {
    static T singleton;
    return &singleton;
  }

protected:
  State() {}

private:
  std::function<void()> callback_;
};

class DriveState : public State<DriveState>
{
  friend class State<DriveState>;
  DriveState() {}
};

class Machine
{
public:
  Machine() { states_["drive"] = DriveState::getInstance(); }
  BaseState *state(const std::string &name) { return states_[name]; }

private:
  std::map<std::string, BaseState *> states_;
};

class Worker
{
public:
  Worker()
  {
    pub_ = nh_.advertise<std_msgs::Empty>("held_out", 1);
    sub_ = nh_.subscribe("held_in", 1, &Worker::callback, this);
  }

private:
  void callback(const std_msgs::Empty &message) { pub_.publish(message); }
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  ros::Subscriber sub_;
};

template <class T>
class Holder
{
public:
  void touch() {}

private:
  T held_;
};

class Driver
{
public:
  Driver()
  {
    pub_ = nh_.advertise<std_msgs::Empty>("driven", 1);
    machine_.state("drive")->setCallback(std::bind(&Driver::drive, this));
  }
  void run()
  {
    ros::Rate rate(1);
    while (ros::ok())
    {
      ros::spinOnce();
      machine_.state("drive")->update();
      rate.sleep();
    }
  }

private:
  void drive() { pub_.publish(std_msgs::Empty()); }
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  Machine machine_;
};

int main(int argc, char **argv)
{
  ros::init(argc, argv, "driver");
  Holder<Worker> holder;
  holder.touch();
  Driver driver;
  driver.run();
}
