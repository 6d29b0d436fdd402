// Which objects are made, and which of their functions run.
//
// expect: publisher made_by_template
// expect: publisher shared
// expect: publisher engine
// expect: publisher traits
// expect: publisher traits_too
// expect: publisher part
// expect: publisher dropped_global
// expect: publisher dropped_local
// expect: publisher initialised
// expect: publisher destroyed
// expect: publisher implemented
// expect: publisher taken
// expect: publisher default
// expect: publisher optional
// expect-only: publisher
// expect-not: reachable(F), function_name(F, Name), contains("never", Name)
// expect: Count = count : { calls(C, F), function_name(F, "Made::Made") }, Count = 1
// expect: Count = count : { makes_instance(C, Class) }, Count = 1
// expect: makes_instance(C, "Made")
// expect: 2 = count : { bound_type(_, _, _, _) }, 30 = count : { reachable(_) }
#include <boost/bind.hpp>
#include <memory>
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <string>
#include <vector>

std::vector<ros::Publisher> g_pubs;

int open(const std::string& name)
{
  g_pubs.push_back(ros::NodeHandle().advertise<std_msgs::Empty>(name, 1));
  return 0;
}

struct Unused
{
  explicit Unused(int)
  {
    open("never_unused");
  }

  ~Unused()
  {
    open("never_destroyed");
  }
};

struct Made
{
  explicit Made(int)
  {
    open("made_by_template");
  }

  Made(int, int)
  {
    open("never_two");
  }

  void set(int)
  {
    open("never_set");
  }
};

struct Unbuilt
{
  explicit Unbuilt(int)
  {
    open("never_built");
  }
};

struct Shared
{
  explicit Shared(int)
  {
    open("shared");
  }

  Shared(int, int)
  {
    open("never_shared_two");
  }

  void run(int)
  {
    open("never_run");
  }
};

struct Cast : Shared
{
  explicit Cast(const std::shared_ptr<Shared>&);
  explicit Cast(int) : Shared(1, 2)
  {
    open("never_cast");
  }
};

struct Engine
{
  Engine() {}

  void start(int)
  {
    open("engine");
  }

  void start(int, int)
  {
    open("never_start");
  }

  void finish(int)
  {
    open("never_finish");
  }
};

struct Traits
{
  static void describe()
  {
    open("traits");
  }

  static void explain()
  {
    open("traits_too");
  }
};

struct Elsewhere
{
  static void describe()
  {
    open("never_described");
  }
};

struct Part
{
  Part()
  {
    open("part");
  }
};

struct NeverPart
{
  NeverPart()
  {
    open("never_part");
  }
};

struct Whole
{
  int count;
  Part part;
};

struct NeverWhole
{
  NeverPart part;
};

struct DroppedGlobal
{
  explicit DroppedGlobal(int)
  {
    open("dropped_global");
  }
};

struct DroppedLocal
{
  explicit DroppedLocal(int)
  {
    open("dropped_local");
  }
};

struct NeverDropped
{
  explicit NeverDropped(int)
  {
    open("never_dropped");
  }
};

struct NeverHeld
{
  explicit NeverHeld(int)
  {
    open("never_held");
  }
};

struct Destroyed
{
  ~Destroyed()
  {
    open("destroyed");
  }
};

// of a library
struct Interface
{
  virtual ~Interface() {}
  virtual void implement() = 0;
};

struct Implementation : Interface
{
  void implement() override
  {
    open("implemented");
  }

  void helper()
  {
    open("never_helper");
  }
};

struct NeverMade : Interface
{
  void implement() override
  {
    open("never_implemented");
  }
};

struct Optional
{
  explicit Optional(int number = 1)
  {
    open("optional");
  }
};

struct Owner
{
  Optional optional;
};

template <class T>
void build()
{
  T made(3);
}

// nobody calls it
template <class T>
void neverBuild()
{
  T made(4);
}

template <class T>
void drive(T& thing)
{
  thing.start(2);
  finish(thing);
}

template <class T>
void report()
{
  T::describe();
}

template <class T>
struct Reporter
{
  void report()
  {
    T::explain();
  }
};

void taken()
{
  open("taken");
}

void neverTaken()
{
  open("never_taken");
}

void keep(void (*action)());
void hold(NeverHeld held);

void take(NeverHeld held)
{
  hold(held);
}

int g_initialised = open("initialised");
DroppedGlobal g_dropped(undeclared_rate + 1);

struct Defaults
{
  int number = open("default");
};

// nobody calls it
void neverCalled()
{
  Unused unused(1);
  NeverDropped dropped(undeclared_rate + 1);
  keep(neverTaken);
  neverBuild<Unbuilt>();
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  build<Made>();
  std::shared_ptr<Shared> shared = std::make_shared<Shared>(1);
  std::shared_ptr<Cast> cast = std::static_pointer_cast<Cast>(shared);
  Engine engine;
  drive(engine);
  report<Traits>();
  Reporter<Traits> reporter;
  reporter.report();
  Whole whole;
  DroppedLocal dropped(undeclared_rate + 1);
  Destroyed destroyed;
  std::unique_ptr<Interface> implementation(new Implementation);
  implementation->implement();
  keep(taken);
  Defaults defaults;
  Owner owner;
  void (*unheld)(NeverHeld) = take;
  ros::spin();
}
