// Timers of Qt: their signal connected by texts and by functions, and what starts and stops them.
//
// expect: Count = count : { qt_connected(C, F) }, Count = 5
// expect: Count = count : { qt_connected(C, F), function_name(F, "Panel::onPoll") }, Count = 1
// expect: Count = count : { qt_connected(C, F), function_name(F, "Base::onInherited") }, Count = 1
// expect: qt_connected(C, F), function_name(F, "Worker::work")
// expect: qt_connected(C, F), function_name(F, "Panel::tick")
// expect: qt_connected(C, F), function(F, "lambda")
// expect: Count = count : { timer_callback(C, F) }, Count = 5
// expect: Count = count : { timer_variable(C, V) }, Count = 5
// expect: timer_variable(C, V), variable_name(V, "poll_timer_")
// expect: Count = count : { activity(F, "timer") }, Count = 5
// expect: periodic /polled 10 Hz
// expect: periodic /ticked
// expect: periodic /inherited
// expect: periodic /worked
// expect: periodic /counted
// expect-only: periodic *
// expect-only: reactive * -> *
#include <QObject>
#include <QTimer>
#include <ros/ros.h>
#include <std_msgs/Empty.h>

ros::Publisher g_polled, g_ticked, g_inherited, g_worked, g_counted, g_never;

class Base : public QObject
{
  Q_OBJECT
public slots:
  void onInherited()
  {
    g_inherited.publish(std_msgs::Empty());
  }
};

class Worker : public QObject
{
  Q_OBJECT
public slots:
  void work()
  {
    g_worked.publish(std_msgs::Empty());
  }
  void onPoll()
  {
    g_never.publish(std_msgs::Empty());
  }
  void workMore()
  {
    g_never.publish(std_msgs::Empty());
  }
};

class Panel : public Base
{
  Q_OBJECT
public:
  Panel()
  {
    connect(&poll_timer_, SIGNAL(timeout()), this, SLOT(onPoll()));
    connect(&poll_timer_, SIGNAL(timeout()), this, SLOT(onAbsent()));
    disconnect(&poll_timer_, SIGNAL(timeout()), this, SLOT(onNever()));
    connect(&other_timer_, SIGNAL(destroyed()), this, SLOT(onNever()));
    connect(&other_timer_, SIGNAL(timeout()), this, SLOT(onInherited()));
    connect(&other_timer_, SIGNAL(timeout()), &worker_, SLOT(work()));
    connect(&third_timer_, &QTimer::timeout, this, &Panel::tick);
    connect(&third_timer_, &QTimer::timeout, [this]() { g_counted.publish(std_msgs::Empty()); });
    connect(&third_timer_, &QTimer::timeout, this, &Panel::absent);
    connect(&worker_, &Worker::work, this, &Panel::onNever);
    poll_timer_.start(100);
  }

  void neverCalled()
  {
    connect(&third_timer_, SIGNAL(timeout()), this, SLOT(onNever()));
    connect(&third_timer_, &QTimer::timeout, this, &Panel::onNever);
  }

  void onPoll(int)
  {
    g_never.publish(std_msgs::Empty());
  }

  void tick()
  {
    g_ticked.publish(std_msgs::Empty());
  }
  void absent();

public slots:
  void onPoll()
  {
    g_polled.publish(std_msgs::Empty());
  }
  void onAbsent();
  void onNever()
  {
    g_never.publish(std_msgs::Empty());
  }

private:
  QTimer poll_timer_, other_timer_, third_timer_;
  Worker worker_;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "panel");
  ros::NodeHandle nh;
  g_polled = nh.advertise<std_msgs::Empty>("/polled", 1);
  g_ticked = nh.advertise<std_msgs::Empty>("/ticked", 1);
  g_inherited = nh.advertise<std_msgs::Empty>("/inherited", 1);
  g_worked = nh.advertise<std_msgs::Empty>("/worked", 1);
  g_counted = nh.advertise<std_msgs::Empty>("/counted", 1);
  g_never = nh.advertise<std_msgs::Empty>("/never", 1);
  Panel panel;
  QCoreApplication::exec();
}
