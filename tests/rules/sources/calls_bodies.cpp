// What is declared alone has no body to enter, in whichever way it is called.
//
// expect: publisher /here
// expect-only: publisher
// expect-not: calls(_, F), !function_defined(F)
// expect: Count = count : { calls(C, F), function_name(F, "Driver::open") }, Count = 1
// expect: Count = count : { calls(C, F), function_name(F, "Special::open") }, Count = 1
// expect: Count = count : { calls(C, F), function_name(F, "Special::close") }, Count = 0
// expect: Count = count : { calls(C, F), function_name(F, "Special::only") }, Count = 0
#include <functional>
#include <memory>
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <utility>

void elsewhere();
void (*g_pointer)() = elsewhere;

struct Driver
{
  Driver();
  virtual ~Driver() {}
  virtual void open()
  {
    ros::Publisher pub = ros::NodeHandle().advertise<std_msgs::Empty>("/here", 1);
  }
  virtual void close() {}
  virtual void only() = 0;
};

struct Special : Driver
{
  explicit Special(int rate);
  void open() override
  {
    Driver::open();
    Driver::close();
  }
  void close() override;
  void only() override;
};

struct Part
{
  explicit Part(int);
  static void describe();
  void start(int);
};

template <class T>
void drive(T& thing)
{
  thing.start(1);
  T::describe();
  T made(2);
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  std::unique_ptr<Driver> driver = std::make_unique<Special>(10);
  driver->open();
  driver->close();
  driver->only();
  elsewhere();
  g_pointer();
  std::function<void()> function = elsewhere;
  function();
  std::pair<int, std::function<void()>> pair(1, elsewhere);
  pair.second();
  Part part(1);
  drive(part);
  ros::spin();
}
