// Virtual calls: the function that the objects have, not that which they inherit; what constructors and explicit calls name is called as it is.
//
// expect: publisher derived
// expect: publisher derived/base_part
// expect: publisher derived/other
// expect: publisher plain
// expect: publisher mixed
// expect: publisher mixed_special
// expect: publisher constructed
// expect: publisher deepest
// expect: publisher library
// expect-only: publisher
// expect: Count = count : { overridden_in(Class, F), function_name(F, "Base::setup") }, Count = 1
// expect: Count = count : { overridden_in(Class, F), function_name(F, "Deep::open") }, Count = 2
// expect: Count = count : { calls(C, F), function_name(F, "Base::setup") }, Count = 0
// expect: Count = count : { calls(C, F), function_name(F, "Base::extend") }, Count = 1
// expect: Count = count : { calls(C, F), function_name(F, "Base::rest") }, Count = 1
// expect: Count = count : { calls(C, F), function_name(F, "Early::make") }, Count = 1
// expect: Count = count : { calls(C, F), function_name(F, "Late::make") }, Count = 0
#include <memory>
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <string>
#include <vector>

std::vector<ros::Publisher> g_pubs;

void open(const std::string& name)
{
  g_pubs.push_back(ros::NodeHandle().advertise<std_msgs::Empty>(name, 1));
}

// all objects are of Derived
class Base
{
public:
  explicit Base(int) {}
  virtual ~Base() {}

  void init()
  {
    setup();
    extend();
  }

protected:
  virtual void setup()
  {
    open("base");
  }

  virtual void extend()
  {
    open("derived/base_part");
  }

  virtual void rest()
  {
    open("derived/other");
  }
};

class Derived : public Base
{
public:
  Derived() : Base(1) {}

private:
  void setup() override
  {
    open("derived");
  }

  void extend() override
  {
    Base::extend();
    reset();
  }

  void rest() override
  {
    open("never_rest");
  }

  void reset()
  {
    Base::rest();
  }
};

// some objects are of the base, some not
class Mixed
{
public:
  virtual ~Mixed() {}

  virtual void setup()
  {
    open("mixed");
  }
};

class Special : public Mixed
{
public:
  void setup() override
  {
    open("mixed_special");
  }
};

class Unmade : public Mixed
{
public:
  void setup() override
  {
    open("never_unmade");
  }
};

// nothing overrides it
class Plain
{
public:
  virtual ~Plain() {}

  virtual void setup()
  {
    open("plain");
  }
};

class Deep
{
public:
  virtual ~Deep() {}

  virtual void open()
  {
    ::open("never_deep");
  }
};

class Deeper : public Deep
{
public:
  void open() override
  {
    ::open("never_deeper");
  }
};

class Deepest : public Deeper
{
public:
  void open() override
  {
    ::open("deepest");
  }
};

// a constructor calls its own class' function
class Early
{
public:
  Early()
  {
    make();
  }

  virtual ~Early() {}

  virtual void make()
  {
    open("constructed");
  }
};

class Late : public Early
{
public:
  void make() override
  {
    open("never_late");
  }
};

// who makes its objects is not known
class Foreign
{
public:
  virtual ~Foreign() {}

  virtual void setup()
  {
    open("library");
  }
};

class ForeignToo : public Foreign
{
public:
  void setup() override
  {
    open("never_foreign");
  }
};

Foreign* makeForeign();

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  std::unique_ptr<Base> base = std::make_unique<Derived>();
  base->init();
  std::vector<std::unique_ptr<Mixed>> mixed;
  mixed.emplace_back(new Mixed);
  mixed.emplace_back(new Special);
  for (auto& each : mixed)
    each->setup();
  std::unique_ptr<Plain> plain(new Plain);
  plain->setup();
  Deep* deep = new Deepest;
  deep->open();
  Late late;
  makeForeign()->setup();
  ros::spin();
}
