// Flags that tell that something has arrived, which all that is sent waits for; and values that a variable never has.
//
// expect: awaits([_, "publisher", "/cmd"], [_, "subscriber", "/pose"], V), variable_name(V, "pose_seen_")
// expect: awaits([_, "publisher", "/path"], [_, "subscriber", "/map"], V), variable_name(V, "map_seen_")
// expect: awaits([_, "publisher", "/speed"], [_, "subscriber", "/odom"], V), variable_name(V, "odom_seen_")
// expect: awaits([_, "publisher", "/goal"], [_, "subscriber", "/plan"], V), variable_name(V, "plan_seen_")
// expect: awaits([_, "publisher", "/deep"], [_, "subscriber", "/plan"], V), variable_name(V, "plan_seen_")
// expect: Count = count : { awaits(Out, In, V) }, Count = 5
// expect: Count = count : { never_is(E, V, Value) }, Count = 5
// expect: never_is(E, V, "Mode::PARKED"), variable_name(V, "mode_"), expr_text(E, "mode_ == PARKED")
// expect: never_is(E, V, "Mode::BROKEN"), variable_name(V, "mode_")
// expect: never_is(E, V, "7"), variable_name(V, "step_"), expr_text(E, "7 == step_")
// expect: never_is(E, V, "9"), variable_name(V, "step_")
// expect: never_is(E, V, "5"), variable_name(V, "bits_")
#include <atomic>
#include <ros/ros.h>
#include <std_msgs/Int32.h>
#include <string>

enum Mode
{
  IDLE,
  DRIVING,
  PARKED,
  BROKEN
};

void readFromDevice(int& value);
int defaultLimit();

class Node
{
public:
  Node() : odom_seen_(false), started_(true), device_(1), armed_(true)
  {
    kind_ = 1;
    cmd_pub_ = nh_.advertise<std_msgs::Int32>("/cmd", 1);
    path_pub_ = nh_.advertise<std_msgs::Int32>("/path", 1);
    speed_pub_ = nh_.advertise<std_msgs::Int32>("/speed", 1);
    goal_pub_ = nh_.advertise<std_msgs::Int32>("/goal", 1);
    deep_pub_ = nh_.advertise<std_msgs::Int32>("/deep", 1);
    free_pub_ = nh_.advertise<std_msgs::Int32>("/free", 1);
    late_pub_ = nh_.advertise<std_msgs::Int32>("/late", 1);
    ready_pub_ = nh_.advertise<std_msgs::Int32>("/ready", 1);
    taken_pub_ = nh_.advertise<std_msgs::Int32>("/taken", 1);
    armed_pub_ = nh_.advertise<std_msgs::Int32>("/armed", 1);
    ready_ = true;
    early_pub_ = nh_.advertise<std_msgs::Int32>("/early", 1);
    either_pub_ = nh_.advertise<std_msgs::Int32>("/either", 1);
    twice_pub_ = nh_.advertise<std_msgs::Int32>("/twice", 1);
    again_pub_ = nh_.advertise<std_msgs::Int32>("/again", step_);
    pose_sub_ = nh_.subscribe("/pose", 1, &Node::onPose, this);
    map_sub_ = nh_.subscribe("/map", 1, &Node::onMap, this);
    odom_sub_ = nh_.subscribe("/odom", 1, &Node::onOdom, this);
    plan_sub_ = nh_.subscribe("/plan", 1, &Node::onPlan, this);
    start_sub_ = nh_.subscribe("/start", 1, &Node::onStart, this);
    joint_sub_ = nh_.subscribe("/joint", 1, &Node::onJoint, this);
    button_sub_ = nh_.subscribe("/button", 1, &Node::onButton, this);
    first_sub_ = nh_.subscribe("/first", 1, &Node::onFirst, this);
    left_sub_ = nh_.subscribe("/left", 1, &Node::onSide, this);
    right_sub_ = nh_.subscribe("/right", 1, &Node::onSide, this);
    reset_sub_ = nh_.subscribe("/reset", 1, &Node::onReset, this);
    timer_ = nh_.createTimer(ros::Duration(0.1), &Node::onTimer, this);
    slow_timer_ = nh_.createTimer(ros::Duration(1.0), &Node::onSlowTimer, this);
  }

private:
  void onPose(const std_msgs::Int32&)
  {
    pose_seen_ = true;
    mode_ = DRIVING;
    step_ = 2;
    raw_ = 2;
    count_ += 2;
    taken_ = false;
    late_seen_ = true;
    armed_ = true;
    limit_ = 2;
    ready_ = true;
    bits_ = 3;
    label_ = "blue";
    key_ = 'a';
  }

  void onMap(const std_msgs::Int32& message)
  {
    map_seen_ = true;
    device_ = 3;
    readFromDevice(device_);
    received_ = message.data;
    int* pointer = &pointed_;
    *pointer = message.data;
    pointed_ = 1;
  }

  void onOdom(const std_msgs::Int32&)
  {
    odom_seen_ = true;
  }

  void onPlan(const std_msgs::Int32&)
  {
    plan_seen_ = true;
  }

  // the flag holds from the start
  void onStart(const std_msgs::Int32&)
  {
    started_ = true;
  }

  // two callbacks set the flag
  void onJoint(const std_msgs::Int32&)
  {
    moved_ = true;
  }

  void onButton(const std_msgs::Int32&)
  {
    moved_ = true;
    pressed_ = true;
  }

  // one callback of two ports sets the flag
  void onSide(const std_msgs::Int32&)
  {
    side_seen_ = true;
  }

  void onFirst(const std_msgs::Int32& message)
  {
    first_seen_ = true;
    again_pub_.publish(message);
  }

  // a flag may be taken back
  void onReset(const std_msgs::Int32&)
  {
    pose_seen_ = false;
    mode_ = IDLE;
  }

  void onTimer(const ros::TimerEvent&)
  {
    std_msgs::Int32 message;
    if (pose_seen_)
      cmd_pub_.publish(message);
    if (odom_seen_)
    {
      if (step_ > 0)
        speed_pub_.publish(message);
    }
    if (started_)
      early_pub_.publish(message);
    if (moved_)
      either_pub_.publish(message);
    if (side_seen_)
      twice_pub_.publish(message);
    if (first_seen_)
      again_pub_.publish(message);
    if (taken_)
      free_pub_.publish(message);
    if (late_seen_)
      late_pub_.publish(message);
    if (ready_)
      ready_pub_.publish(message);
    if (taken_)
      taken_pub_.publish(message);
    if (armed_)
      armed_pub_.publish(message);
    if (limit_ == 5)  // who knows what it is at first
      free_pub_.publish(message);
    if (pressed_)
      free_pub_.publish(message);
    else if (step_ == 1)
      free_pub_.publish(message);
    if (!map_seen_)
      return;
    path_pub_.publish(message);
  }

  void onSlowTimer(const ros::TimerEvent&)
  {
    if (!plan_seen_)
      return;
    sendGoal();
    decide();
  }

  void report(int step)
  {
    ROS_INFO("step %d", step);
  }

  void sendGoal()
  {
    std_msgs::Int32 message;
    goal_pub_.publish(message);
    if (mode_ == DRIVING)
      deep_pub_.publish(message);
  }

  void decide()
  {
    std_msgs::Int32 message;
    if (mode_ == PARKED)
      goal_pub_.publish(message);
    if (7 == step_)
      goal_pub_.publish(message);
    if (step_ != 8)
      goal_pub_.publish(message);
    if (device_ == 5)
      goal_pub_.publish(message);
    if (received_ == 5)
      goal_pub_.publish(message);
    if (pointed_ == 5)
      goal_pub_.publish(message);
    if (kind_ == 5)  // no state, it stays as it is
      goal_pub_.publish(message);
    if (raw_ == 5)  // who knows what it is at first
      goal_pub_.publish(message);
    if (label_ == "green")  // only numbers are looked at
      goal_pub_.publish(message);
    if ((bits_ & 4) == 4)
      goal_pub_.publish(message);
    if (bits_ == 5)
      goal_pub_.publish(message);
    if (mode_ != PARKED)
      goal_pub_.publish(message);
    message.data = mode_ == PARKED;  // nothing hangs on it
    message.data = step_ == 9;
    message.data = -step_;
    if (count_ == 5)
      goal_pub_.publish(message);
    report(step_);
    switch (key_)
    {
      case 'q':
        goal_pub_.publish(message);
    }
    if (step_ == 2 || step_ == 1)
      goal_pub_.publish(message);
    switch (mode_)
    {
      case DRIVING:
        goal_pub_.publish(message);
        break;
      case BROKEN:
        deep_pub_.publish(message);
        break;
      default:
        break;
    }
    switch (step_)
    {
      case 1:
        goal_pub_.publish(message);
        break;
      case 9:
        deep_pub_.publish(message);
        break;
    }
  }

  ros::NodeHandle nh_;
  ros::Publisher cmd_pub_, path_pub_, speed_pub_, goal_pub_, deep_pub_, free_pub_, early_pub_, either_pub_, twice_pub_, again_pub_, late_pub_, ready_pub_, taken_pub_, armed_pub_;
  ros::Subscriber pose_sub_, map_sub_, odom_sub_, plan_sub_, start_sub_, joint_sub_, button_sub_, first_sub_, left_sub_, right_sub_, reset_sub_;
  ros::Timer timer_, slow_timer_;
  bool pose_seen_ = false;
  bool map_seen_{false};
  bool odom_seen_;
  std::atomic<bool> plan_seen_{false};
  bool started_, moved_ = false, side_seen_ = false, pressed_ = false, first_seen_ = false, taken_ = false, late_seen_, ready_ = false, armed_ = false;
  Mode mode_ = IDLE;
  int step_ = 1, device_, received_ = 1, pointed_ = 1, raw_, bits_ = 1, count_ = 1, kind_, limit_ = defaultLimit();
  std::string label_ = "red";
  char key_ = 'b';
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  Node node;
  ros::spin();
}
