// Which objects live as long as the component, which of them are plain data, and what changes what they hold.
//
// expect: N = count : { component_variable(_) }, N = 31
// expect: N = count : { assignment(_, _, _) }, N = 30
// expect: N = count : { changes_by_other_name(_, _) }, N = 1
// expect: N = count : { final_value(_, _) }, N = 31
// expect: N = count : { parameter_assigned(_, _) }, N = 5
// expect: N = count : { part_of_variable(_, _) }, N = 59
// expect: N = count : { plain_class(Class), location(Class, _, _, _) }, N = 5
// expect: plain_class("Pose")
// expect: plain_class("Size")
// expect: plain_class("Short::Inner")
// expect: 1 = count : { gives_constant(_, _, _, _) }, 13 = count : { value_step(_, _, _) }
#include <boost/make_shared.hpp>
#include <iostream>
#include <map>
#include <memory>
#include <ros/ros.h>
#include <std_msgs/Float64.h>
#include <tf/tf.h>
#include <vector>

struct Pose
{
  Pose& operator+=(const Pose& other)
  {
    x += other.x;
    return *this;
  }
  double squared() const
  {
    double sum = 0;
    sum += x * x;
    return sum;
  }
  double x = 0;
  static int made;  // expect-only: component_variable(V)
};
int Pose::made = 0;

struct Size
{
  Size()
  {
    width = 1;
  }
  void copyTo(Size& other, int& number) const
  {
    Pose pose;
    pose.x = 1;
    other.width = width;
    number = width;
  }
  int width;
};

struct Output
{
  ros::Publisher pub;
  double last = 0;  // expect-only: component_variable(V)
};

enum class Mode
{
  IDLE,
  RUN
};

class Counter
{
public:
  void count()
  {
    ++count_;
  }
  int count_ = 0;  // expect-only: component_variable(V)
  const int most_ = 9;
};

class History
{
public:
  void add(double value)
  {
    values_.push_back(value);
  }
  std::vector<double> values_;  // expect-only: component_variable(V)
};

class Limits
{
public:
  void load(ros::NodeHandle& nh)
  {
    nh.getParam("limit", limit_);
  }
  double limit_ = 1;  // expect-only: component_variable(V)
};

class Grid
{
public:
  void clear(int index)
  {
    cells_[index] = 0;
  }
  int cells_[4];  // expect-only: component_variable(V)
};

class Pointing
{
public:
  void clear()
  {
    *target_ = 0;
  }
  double* target_ = nullptr;  // expect-only: component_variable(V)
};

class Arm
{
public:
  void home()
  {
    pose_.x = 0;
  }
  Pose pose_;  // expect-only: component_variable(V)
};

class Part
{
public:
  virtual ~Part()
  {
  }
  int steps_ = 0;  // expect-only: component_variable(V)
};

class Wheel : public Part
{
public:
  void step()
  {
    steps_ += 1;
  }
};

class Short
{
public:
  void change()
  {
    value_ = 1;
  }
  struct Inner
  {
    int number = 0;
  };
  Inner inner_;
  int value_ = 0;
};

class Unused
{
public:
  void change()
  {
    value_ = 1;
  }
  int value_ = 0;
};

class Unshared
{
public:
  void change()
  {
    value_ = 1;
  }
  int value_ = 0;
};

class Filter
{
public:
  void onIn(const std_msgs::Float64& message)
  {
    last_ = message.data;
  }
  double last_ = 0;  // expect-only: component_variable(V)
};

void never()
{
  Unused* unused = new Unused;
  boost::shared_ptr<Unshared> unshared = boost::make_shared<Unshared>();
}

class Robot
{
public:
  explicit Robot(ros::NodeHandle& nh) : wheel_(new Wheel), grid_(boost::make_shared<Grid>())
  {
    pub_ = nh.advertise<std_msgs::Float64>("/out", 1);
    limits_.load(nh);
  }
  void onIn(const std_msgs::Float64& message);

private:
  ros::Publisher pub_;
  Limits limits_;  // expect-only: component_variable(V)
  std::unique_ptr<Wheel> wheel_;  // expect-only: component_variable(V)
  boost::shared_ptr<Grid> grid_;  // expect-only: component_variable(V)
  Arm arm_;  // expect-only: component_variable(V)
  Pointing pointing_;  // expect-only: component_variable(V)
  Pose pose_, goal_;  // expect-only: component_variable(V)
  Mode mode_ = Mode::IDLE;  // expect-only: component_variable(V)
  double scale_ = 1, roll_, pitch_, yaw_;  // expect-only: component_variable(V)
  ros::NodeHandle nh_;
  std::string found_;  // expect-only: component_variable(V)
  std::map<int, double> gains_;  // expect-only: component_variable(V)
  std::pair<int, int> range_;  // expect-only: component_variable(V)
  Size size_;  // expect-only: component_variable(V)
  Output output_;  // expect-only: component_variable(V)
  std::vector<double> samples_;  // expect-only: component_variable(V)
};

Counter g_counter;  // expect-only: component_variable(V)

void raise(double (&values)[2], double& value, double by)
{
  values[0] = 1;
  value += by;
}

void raisePose(Pose& pose, double by)
{
  pose.x += by;
}

double look(const Pose& pose, Pose copy)
{
  copy.x = 2;
  return pose.x;
}

double g_pair[2];  // expect-only: component_variable(V)

void Robot::onIn(const std_msgs::Float64& message)
{
  static History history;  // expect-only: component_variable(V)
  Short brief;
  brief.change();
  double local = 0;
  g_counter.count();
  history.add(message.data);
  wheel_->step();
  grid_->clear(1);
  arm_.home();
  pointing_.clear();
  mode_ = Mode::RUN;
  goal_ = pose_;
  pose_.x = message.data;
  local = scale_ = roll_ = message.data;
  scale_ *= 2;
  samples_.at(0) = local;
  samples_.clear();
  range_.first = 1;
  range_ = std::make_pair(1, 2);
  output_.last = *samples_.begin();
  nh_.searchParam("name", found_);
  std::cout << found_ << size_.width;
  gains_[1] = 2;
  tf::Matrix3x3(tf::Quaternion()).getRPY(roll_, pitch_, yaw_);
  raise(g_pair, yaw_, 1);
  raisePose(goal_, scale_);
  pitch_ = look(goal_, pose_);
  yaw_ = pitch_ + roll_;
  if (samples_.size() > 1)
    pub_.publish(message);
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  Robot robot(nh);
  Filter filter;
  ros::Subscriber sub = nh.subscribe("/in", 1, &Robot::onIn, &robot);
  ros::Subscriber filtered = nh.subscribe("/filtered", 1, &Filter::onIn, &filter);
  ros::spin();
}
