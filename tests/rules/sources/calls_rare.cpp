// Calls that are seldom written so: of what a lambda captures by a name of its own, by a destructor, with other arguments than the function takes.
//
// expect: calls(C, F), function_name(F, "onCaptured")
// expect: Count = count : { calls(C, F), function_name(F, "Base::shut") }, Count = 1
// expect: Count = count : { calls(C, F), function_name(F, "Derived::shut") }, Count = 0
// expect: Count = count : { calls(C, F), function_name(F, "Worker::work") }, Count = 1
// expect: Count = count : { calls(C, F), function_name(F, "Worker::rest") }, Count = 0
// expect: Count = count : { function_holder(V, F), function_name(F, "onCaptured") }, Count = 2
// expect: publisher captured
// expect: publisher base
// expect: publisher worked
// expect-only: publisher *
// expect: _called_inside(_, V), variable_name(V, "action"), 1 = count : { _called_inside(_, _) }
// expect-not: _assigned(_); timer_variable(_, _); _enters_at(_, _); _of_parameter_type(_); template_made_with(_, _); asks_if_empty(_, _)
// expect: 12 = count : { expr_class(_, _) }, 16 = count : { made_of(_, _) }, 12 = count : { place_of(_, _) }
// expect-not: given_role(_, _, _, _, _)
#include <functional>
#include <ros/ros.h>
#include <std_msgs/Empty.h>

void open(const char* name)
{
  ros::NodeHandle().advertise<std_msgs::Empty>(name, 1);
}

void onCaptured()
{
  open("captured");
}

class Base
{
public:
  virtual ~Base()
  {
    shut();
  }

  virtual void shut()
  {
    open("base");
  }
};

class Derived : public Base
{
public:
  void shut() override
  {
    open("never");
  }
};

class Worker
{
public:
  void work(int)
  {
    open("worked");
  }

  void rest(int)
  {
    open("never");
  }
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  std::function<void()> kept = onCaptured;
  auto later = [action = std::move(kept)]() { action(); };
  later();
  Base* base = new Derived;
  delete base;
  Worker worker;
  worker.work(1, 2);  // not what the function at hand takes
  ros::spin();
}
