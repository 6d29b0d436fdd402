// Ports that templates make: their types are those of the instances that there are, their callbacks those of the objects.
//
// expect: publisher /talk/int std_msgs/Int32
// expect: publisher /talk/text std_msgs/String
// expect: subscriber /heard std_msgs/Bool callback=Listener::onMessage
// expect: publisher /made/int std_msgs/Int32
// expect: publisher /made/text std_msgs/String
// expect: publisher /traits std_msgs/Float32
// expect: publisher /derived std_msgs/UInt8
// expect: publisher /pointed std_msgs/Int64
// expect: subscriber /stored std_msgs/Float64 callback=Store::onMessage
// expect: publisher /field std_msgs/Int8
// expect-only: publisher
// expect-only: subscriber
// expect: Count = count : { instantiated(Site, Context, Type, Instance) }, Count = 16
// expect: 7 = count : { chained_type(_, _) }
#include <memory>
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_msgs/Float32.h>
#include <std_msgs/Float64.h>
#include <std_msgs/Int32.h>
#include <std_msgs/Int64.h>
#include <std_msgs/Int8.h>
#include <std_msgs/String.h>
#include <std_msgs/UInt8.h>
#include <string>

template <class Message>
class Talker
{
public:
  Talker(ros::NodeHandle& nh, const std::string& name)
  {
    pub_ = nh.advertise<Message>("/talk/" + name, 1);
  }

private:
  ros::Publisher pub_;
};

template <class Message>
class Listener
{
public:
  explicit Listener(ros::NodeHandle& nh)
  {
    sub_ = nh.subscribe("/heard", 1, &Listener::onMessage, this);
  }

private:
  void onMessage(const boost::shared_ptr<Message const>&) {}

  ros::Subscriber sub_;
};

template <class Message>
ros::Publisher make(ros::NodeHandle& nh, const std::string& name)
{
  return nh.advertise<Message>("/made/" + name, 1);
}

struct Traits
{
  typedef std_msgs::Float32 Output;
};

template <class T>
class Adapter
{
public:
  explicit Adapter(ros::NodeHandle& nh) : pub_(nh.advertise<typename T::Output>("/traits", 1)) {}

private:
  ros::Publisher pub_;
};

template <class Message>
class Base
{
protected:
  void open(ros::NodeHandle& nh)
  {
    pub_ = nh.advertise<Message>("/derived", 1);
  }

  ros::Publisher pub_;
};

class Derived : public Base<std_msgs::UInt8>
{
public:
  explicit Derived(ros::NodeHandle& nh)
  {
    open(nh);
  }
};

template <class Message>
class Pointed
{
public:
  explicit Pointed(ros::NodeHandle& nh)
  {
    pub_ = nh.advertise<Message>("/pointed", 1);
  }

private:
  ros::Publisher pub_;
};

template <class Message>
class Store
{
public:
  void listen(ros::NodeHandle& nh)
  {
    sub_ = nh.subscribe<Message>("/stored", 1, &Store::onMessage, this);
  }

private:
  void onMessage(const typename Message::ConstPtr&) {}

  ros::Subscriber sub_;
};

class Holder
{
public:
  explicit Holder(ros::NodeHandle& nh) : inner_(nh) {}

private:
  template <class Message>
  class Inner
  {
  public:
    explicit Inner(ros::NodeHandle& nh) : pub_(nh.advertise<Message>("/field", 1)) {}

  private:
    ros::Publisher pub_;
  };

  Inner<std_msgs::Int8> inner_;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  Talker<std_msgs::Int32> numbers(nh, "int");
  Talker<std_msgs::String> texts(nh, "text");
  Listener<std_msgs::Bool> listener(nh);
  ros::Publisher int_pub = make<std_msgs::Int32>(nh, "int");
  ros::Publisher text_pub = make<std_msgs::String>(nh, "text");
  Adapter<Traits> adapter(nh);
  Derived derived(nh);
  std::unique_ptr<Pointed<std_msgs::Int64>> pointed = std::make_unique<Pointed<std_msgs::Int64>>(nh);
  Store<std_msgs::Float64> store;
  store.listen(nh);
  Holder holder(nh);
  ros::spin();
}
