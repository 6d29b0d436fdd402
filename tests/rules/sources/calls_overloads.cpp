// Overloads, where the compiler cannot tell which one is called: those that take as many arguments, and a text where a text is given.
//
// expect: publisher text
// expect: publisher text/queue
// expect: publisher text_of_variable
// expect: publisher number
// expect: publisher real
// expect: publisher truth
// expect: publisher pointer
// expect: publisher shared_text
// expect: publisher base_text
// expect: publisher no_other
// expect: publisher no_count_a
// expect: publisher no_count_b
// expect: publisher converted
// expect: publisher converted_by_function
// expect: publisher any_a
// expect: publisher any_b
// expect-only: publisher
// expect: N = count : { template_argument_for(_, _, _, _) }, N = 1
#include <memory>
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <string>
#include <vector>

std::vector<ros::Publisher> g_pubs;

void advertise(const std::string& name)
{
  g_pubs.push_back(ros::NodeHandle().advertise<std_msgs::Empty>(name, 1));
}

struct Options
{
  int queue;
};

struct Bounds
{
};

// a text, a number, options, or a pointer to options
void byText(const std::string&, const Bounds&)
{
  advertise("text");
}

void byText(const std::string&, const Bounds&, int queue)
{
  advertise("never_three");
}

void byText(const std::string&)
{
  advertise("never_one");
}

void byText(const std::string&, const Bounds&, bool latch = false, int queue = 1)
{
  advertise("text/queue");
}

void byText(const Options&, const Bounds&)
{
  advertise("never_options");
}

void byText(std::shared_ptr<Options>, const Bounds&)
{
  advertise("never_pointer");
}

void byVariable(const std::string&, const Bounds&)
{
  advertise("text_of_variable");
}

void byVariable(const Options&, const Bounds&)
{
  advertise("never_options_of_variable");
}

void byNumber(int, const Bounds&)
{
  advertise("number");
}

void byNumber(const std::string&, const Bounds&)
{
  advertise("never_text_of_number");
}

void byReal(double, const Bounds&)
{
  advertise("real");
}

void byReal(const std::string&, const Bounds&)
{
  advertise("never_text_of_real");
}

void byTruth(bool, const Bounds&)
{
  advertise("truth");
}

void byTruth(std::string, const Bounds&)
{
  advertise("never_text_of_truth");
}

// nothing is known of what is given: any of them
void byAny(const std::string&, const Bounds&)
{
  advertise("any_a");
}

void byAny(const Options&, const Bounds&)
{
  advertise("any_b");
}

// the one that takes two: it is made of the text
void byOne(const Options&, const Bounds&)
{
  advertise("no_other");
}

void byOne(const Options&)
{
  advertise("never_one_of_one");
}

// no one takes as many: one has a parameter more in a header that is not there
void byNone(const std::string&)
{
  advertise("no_count_a");
}

void byNone(int)
{
  advertise("no_count_b");
}

// the compiler can tell
struct Label
{
  Label(const char*) {}
};

struct Sign
{
  explicit Sign(const Label&)
  {
    advertise("converted");
  }

  explicit Sign(int)
  {
    advertise("never_sign");
  }
};

void byLabel(const Label&)
{
  advertise("converted_by_function");
}

void byLabel(double)
{
  advertise("never_label");
}

// classes
struct Shared
{
  Shared(const std::string&, int)
  {
    advertise("shared_text");
  }

  Shared(const Options&, int)
  {
    advertise("never_shared_options");
  }

  Shared(const std::string&)
  {
    advertise("never_shared_one");
  }
};

class Base
{
public:
  Base(const std::string&, const Bounds&)
  {
    advertise("base_text");
  }

  Base(const Options&, const Bounds&)
  {
    advertise("never_base_options");
  }

  explicit Base(const std::string&)
  {
    advertise("never_base_one");
  }

  void set(const std::string&, const Bounds&)
  {
    advertise("never_set");
  }
};

template <class T>
class Derived : public Base
{
public:
  explicit Derived(const T& bounds) : Base("f", bounds)
  {
  }
};

void byPointer(std::shared_ptr<Options>, const Bounds&)
{
  advertise("never_pointer_of_pointer");
}

void byPointer(const char*, const Bounds&)
{
  advertise("pointer");
}

template <class T>
void configure(const T& bounds)
{
  byText("a", bounds);
  std::string name = "b";
  byVariable(name, bounds);
  byNumber(5, bounds);
  byReal(0.5, bounds);
  byTruth(true, bounds);
  byAny(bounds.name(), bounds);
  byPointer("c", bounds);
  byOne("d", bounds);
  byNone("e", bounds);
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  configure(Bounds());
  std::shared_ptr<Shared> shared = std::make_shared<Shared>("g", 1);
  Sign sign("h");
  byLabel("i");
  Derived<Bounds> derived((Bounds()));
  ros::spin();
}
