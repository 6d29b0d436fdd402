// Modes that are never left, or that nothing leads to, and others that only look so.
// expect-not: finding ignored-in-state "*paused*"
// expect-not: finding ignored-in-state "*map*"
// expect-not: finding ignored-in-state "*/log*"
// expect-not: finding state-not-reached "*RUNNING*"
// expect-not: finding state-not-reached "*READY*"
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <std_msgs/String.h>

enum Mode { IDLE, RUNNING, STOPPED };
enum Phase { AWAY, READY, APPROACHING, DOCKED };

class Dock {
 public:
  Dock() {
    report_pub_ = nh_.advertise<std_msgs::String>("report", 1);
    timer_ = nh_.createTimer(ros::Duration(1.0), &Dock::onTimer, this);
    goal_sub_ = nh_.subscribe("question", 1, &Dock::onGoal, this);  // expect: finding ignored-in-state "/dock ignores /question while Dock::mode_ is Mode::STOPPED, and it stays so"
    stop_sub_ = nh_.subscribe("stop", 1, &Dock::onStop, this);
    pause_sub_ = nh_.subscribe("answer", 1, &Dock::onAnswer, this);
    map_sub_ = nh_.subscribe("map", 1, &Dock::onMap, this);
    log_sub_ = nh_.subscribe("log", 1, &Dock::onLog, this);
    settings_sub_ = nh_.subscribe("settings", 1, &Dock::onSettings, this);  // expect: finding ignored-in-state "/dock ignores /settings while Dock::phase_ is Phase::AWAY, as it is when the only message is sent"
  }

 private:
  void onGoal(const std_msgs::String& goal) {
    ROS_INFO("goal in mode %d", mode_);
    if (mode_ == STOPPED) return;
    mode_ = RUNNING;
    report_pub_.publish(goal);
  }
  void onStop(const std_msgs::String&) { mode_ = STOPPED; }
  // it goes on after a pause
  void onAnswer(const std_msgs::String& answer) {
    if (!paused_) report_pub_.publish(answer);
  }
  // only the first map is wanted
  void onMap(const std_msgs::String& map) {
    if (has_map_) return;
    has_map_ = true;
    report_pub_.publish(map);
  }
  // something happens in every mode
  void onLog(const std_msgs::String& text) {
    if (mode_ == RUNNING) report_pub_.publish(text);
    last_ = text;
  }
  void onSettings(const std_msgs::String& settings) {
    switch (phase_) {
      case READY: report_pub_.publish(settings); break;
      default: break;
    }
  }
  void onTimer(const ros::TimerEvent&) {
    if (paused_) {
      paused_ = false;
    } else {
      paused_ = true;
    }
    if (mode_ == RUNNING && phase_ == AWAY) phase_ = READY;
    if (phase_ == APPROACHING) phase_ = DOCKED;  // expect: finding state-not-reached "/dock tests whether Dock::phase_ is Phase::APPROACHING, which no sequence of inputs reaches"
    if (phase_ == DOCKED) {                      // expect: finding state-not-reached "/dock tests whether Dock::phase_ is Phase::DOCKED,*"
      phase_ = APPROACHING;
      report_pub_.publish(last_);
    }
  }

  ros::NodeHandle nh_;
  ros::Publisher report_pub_;
  ros::Timer timer_;
  ros::Subscriber goal_sub_, stop_sub_, pause_sub_, map_sub_, log_sub_, settings_sub_;
  std_msgs::String last_;
  Mode mode_ = IDLE;
  Phase phase_ = AWAY;
  bool paused_ = false;
  bool has_map_ = false;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "dock");
  Dock dock;
  ros::spin();
}
