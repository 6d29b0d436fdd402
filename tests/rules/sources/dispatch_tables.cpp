// Handlers in a map that the constructor fills; in another one a callback exchanges a handler, so that it is not known which is called.
//
// expect: entered_by_choice(_, F, Index, _), expr_text(Index, "state_"), function_name(F, "Machine::done")
// expect: port_flow([_, _, "/begin"], [_, _, "/cmd"], "control", _)
// expect: 0 = count : { entered_by_choice(_, _, Index, Key), expr_text(Index, "other_"), expr_text(Key, _) }
// expect: chosen_call(C, _), location(C, _, 34, _)
#include <functional>
#include <map>
#include <ros/ros.h>
#include <std_msgs/Empty.h>

enum class State { IDLE, MOVING, DONE };

class Machine {
 public:
  explicit Machine(ros::NodeHandle& n) {
    cmd_ = n.advertise<std_msgs::Empty>("/cmd", 1);
    end_ = n.advertise<std_msgs::Empty>("/end", 1);
    begin_ = n.subscribe("/begin", 1, &Machine::begin, this);
    handlers_[State::IDLE] = [this]() { idle(); };
    handlers_[State::MOVING] = std::bind(&Machine::moving, this);
    handlers_[State::DONE] = std::bind(&Machine::done, this);
    changing_[0] = [this]() { moving(); };
    exchange_ = n.subscribe("/exchange", 1, &Machine::exchange, this);
    tock_ = n.createTimer(ros::Duration(0.5), &Machine::tock, this);
    timer_ = n.createTimer(ros::Duration(0.1), &Machine::tick, this);
  }
  void begin(const std_msgs::Empty&) { if (state_ == State::IDLE) state_ = State::MOVING; }
  void idle() {}
  void moving() { cmd_.publish(std_msgs::Empty()); state_ = State::DONE; }
  void done() { end_.publish(std_msgs::Empty()); state_ = State::IDLE; }
  void tick(const ros::TimerEvent&) { handlers_[state_](); }
  void exchange(const std_msgs::Empty&) { changing_[1] = [this]() { idle(); }; other_ = 1; }
  void tock(const ros::TimerEvent&) { changing_[other_](); }
 private:
  State state_ = State::IDLE;
  std::map<State, std::function<void()>> handlers_;
  ros::Publisher cmd_, end_;
  int other_ = 0;
  std::map<int, std::function<void()>> changing_;
  ros::Subscriber begin_, exchange_;
  ros::Timer timer_, tock_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "machine");
  ros::NodeHandle n;
  Machine machine(n);
  ros::spin();
}
