// Of which type parameters are: told by the variable, the default, the template, or by what a template is called with.
//
// expect: N = count : { parameter_access_type(_, _, _) }, N = 26
// expect: N = count : { parameter_operand_type(_, _) }, N = 36
// expect: N = count : { parameter_access_default(_, _, _) }, N = 13
// expect: N = count : { parameter_access(_, _, _) }, N = 28
// expect: N = count : { node_name_argument(_, _) }, N = 2
// expect: N = count : { constant_text(_, "") }, N = 2
// expect-only: param
// expect: param ~handed_double type=double
// expect: param ~handed_bool type=bool
// expect: param ~made_int type=int
// expect: param ~made_string = base type=string
// expect: 6 = count : { default_text(_, _) }
// expect-not: constant_condition(_, _); written_through(_)
#include <absent_vendor/gain.h>
#include <ros/ros.h>
#include <string>
#include <vector>

struct Values
{
  int number;
  double factor;
};

enum Mode
{
  IDLE,
  RUN
};

ros::NodeHandle* g_nh;

template <typename T>
void readInto(const std::string& name, T& value)
{
  g_nh->getParam(name, value);
}

template <typename T>
T readOr(const std::string& name, const T& otherwise)
{
  return g_nh->param<T>(name, otherwise);
}

template <typename T>
void show(const T& value)
{
  ROS_INFO_STREAM(value);
}

void read(int& number, const double& factor, double* pointer)
{
  g_nh->getParam("reference", number);  // expect: param ~reference type=int
  g_nh->setParam("constant", factor);  // expect: param ~constant type=double op=write
  g_nh->getParam("pointed", *pointer);  // expect: param ~pointed type=double
}

void never()
{
  ros::NodeHandle nh;
  int number;
  nh.getParam("never", number);
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "types");
  ros::NodeHandle nh("~");
  g_nh = &nh;

  bool flag = true;
  int number = 3, count;
  double factor = 0.5;
  std::string text;
  std::vector<int> numbers;
  nh.getParam("flag", flag);  // expect: param ~flag = true type=bool
  nh.getParam("number", number);  // expect: param ~number = 3 type=int
  nh.getParam("text", text);  // expect: param ~text default= type=string
  nh.getParam("numbers", numbers);  // expect: param ~numbers type=std::vector<int>
  nh.param("count", count, 2 + 3);  // expect: param ~count = 5 type=int
  nh.param<double>("given", factor, 1);  // expect: param ~given = 1 type=double
  const bool on = nh.param("on", false);  // expect: param ~on = false type=bool
  const std::string name = nh.param<std::string>("name", "");  // expect: param ~name = "" type=string
  const double half = nh.param("half", factor / 2);  // expect: param ~half type=double
  nh.setParam("written", 7);  // expect: param ~written type=int op=write
  nh.setParam("sum", number + 1);  // expect: param ~sum type=int op=write
  nh.setParam("negated", !flag);  // expect: param ~negated op=write
  nh.setParam("mode", RUN);  // expect: param ~mode op=write
  Values values;
  nh.getParam("values/number", values.number);  // expect: param ~values/number type=int
  nh.getParam("values/factor", values.factor);  // expect: param ~values/factor type=double
  absent_vendor::Gain gain;
  nh.param("gain", gain, 1.5);  // expect: param ~gain = 1.5 type=absent_vendor::Gain
  nh.param("part", gain.part, 1.5);  // expect: param ~part = 1.5 type=double
  AbsentType limit;
  nh.param("limit", limit, 2.5);  // expect: param ~limit = 2.5 type=AbsentType
  if (nh.hasParam("flag"))  // expect: param ~flag op=has
    nh.deleteParam("flag");  // expect: param ~flag op=delete
  nh.getParam(argv[1], count);  // expect: param ? type=int

  read(number, factor, &factor);
  readInto("handed_double", factor);
  readInto("handed_bool", flag);
  readOr<int>("made_int", 4);
  readOr<std::string>("made_string", "base");
  show(number);
  ros::spin();
}
