// Ways of a value from the message that arrives into those that are sent, each with a publisher of its own; the value may be
// in it (data), or decide what is in it (control). All are sent because the message arrived.
//
// expect: port_flow([_, _, "/in"], [_, _, "/assigned_value"], "data", "reactive")
// expect: port_flow([_, _, "/in"], [_, _, "/comma"], "data", "reactive")
// expect: port_flow([_, _, "/in"], [_, _, "/chosen"], "data", "reactive")
// expect: port_flow([_, _, "/in"], [_, _, "/other_chosen"], "data", "reactive")
// expect: port_flow([_, _, "/in"], [_, _, "/element"], "data", "reactive")
// expect: port_flow([_, _, "/in"], [_, _, "/negated"], "data", "reactive")
// expect: port_flow([_, _, "/in"], [_, _, "/through_pointer"], "data", "reactive")
// expect: port_flow([_, _, "/in"], [_, _, "/through_reference"], "data", "reactive")
// expect: port_flow([_, _, "/in"], [_, _, "/through_later_pointer"], "data", "reactive")
// expect: port_flow([_, _, "/in"], [_, _, "/added"], "data", "reactive")
// expect: port_flow([_, _, "/in"], [_, _, "/array"], "data", "reactive")
// expect: port_flow([_, _, "/in"], [_, _, "/stream"], "data", "reactive")
// expect: port_flow([_, _, "/in"], [_, _, "/range"], "data", "reactive")
// expect: port_flow([_, _, "/in"], [_, _, "/member"], "data", "reactive")
// expect: port_flow([_, _, "/in"], [_, _, "/returned"], "data", "reactive")
// expect: port_flow([_, _, "/in"], [_, _, "/filled"], "data", "reactive")
// expect: port_flow([_, _, "/in"], [_, _, "/filled_by_pointer"], "data", "reactive")
// expect: port_flow([_, _, "/in"], [_, _, "/method"], "data", "reactive")
// expect: port_flow([_, _, "/in"], [_, _, "/called_object"], "data", "reactive")
// expect: port_flow([_, _, "/in"], [_, _, "/lambda"], "data", "reactive")
// expect: port_flow([_, _, "/in"], [_, _, "/bound_to_local"], "data", "reactive")
// expect: port_flow([_, _, "/in"], [_, _, "/undeclared_last"], "data", "reactive")
// expect: port_flow([_, _, "/in"], [_, _, "/undeclared_pointer"], "data", "reactive")
// expect: port_flow([_, _, "/in"], [_, _, "/undeclared_address"], "data", "reactive")
// expect: port_flow([_, _, "/in"], [_, _, "/undeclared_for_value"], "data", "reactive")
// expect: port_flow([_, _, "/in"], [_, _, "/library_reference"], "data", "reactive")
// expect: port_flow([_, _, "/in"], [_, _, "/library_object"], "data", "reactive")
// expect: port_flow([_, _, "/in"], [_, _, "/filled_vector"], "data", "reactive")
// expect: sent_from(C, _, "control"), sends(C, [_, _, "/choosing"])
// expect: sent_from(C, _, "control"), sends(C, [_, _, "/index"])
// expect-not: sent_from(C, _, _), sends(C, [_, _, "/size"])
// expect-not: sent_from(C, _, _), sends(C, [_, _, "/through_const_reference"])
// expect-not: sent_from(C, _, _), sends(C, [_, _, "/const_stream"])
// expect-not: sent_from(C, _, _), sends(C, [_, _, "/returned_other"])
// expect: sent_from(C, _, "control"), sends(C, [_, _, "/returned_by_condition"])
// expect-not: sent_from(C, _, _), sends(C, [_, _, "/other_object"])
// expect: sent_from(C, _, "control"), sends(C, [_, _, "/under_condition"])
// expect: sent_from(C, _, "control"), sends(C, [_, _, "/counted_under_condition"])
// expect-not: sent_from(C, _, _), sends(C, [_, _, "/undeclared_unchanged"])
// expect-not: sent_from(C, _, _), sends(C, [_, _, "/library_constant"])
// expect: port_flow([_, _, "/in"], [_, _, "/std_function"], "data", "reactive")
// expect: port_flow([_, _, "/in"], [_, _, "/through_method_reference"], "data", "reactive")
// expect: sent_from(C, _, "control"), sends(C, [_, _, "/decremented_under_condition"])
// expect: sent_from(C, _, "control"), sends(C, [_, _, "/under_two_conditions"])
// expect: sent_from(C, _, "control"), sends(C, [_, _, "/in_a_case"])
// expect: sent_from(C, _, "control"), sends(C, [_, _, "/as_often"])
// expect: sent_from(C, _, "control"), sends(C, [_, _, "/returned_afterwards"])
// expect-not: sent_from(C, _, _), sends(C, [_, _, "/before_condition"])
// expect-not: sent_from(C, _, _), sends(C, [_, _, "/returned_in_any_case"])
// expect-not: sent_from(C, _, _), sends(C, [_, _, "/under_another_condition"])
// expect: Count = count : { port_flow(_, _, "data", _) }, Count = 30
// expect: Count = count : { sent_from(_, _, "control") }, Count = 11
// expect: Count = count : { port_flow(_, _, _, _) }, Count = 50
#include <functional>
#include <ros/ros.h>
#include <sstream>
#include <std_msgs/Int32.h>
#include <undeclared/undeclared.h>

// of other packages
namespace library
{
void convert(int from, int& to);
void print(int first, const int& second);
class Box
{
public:
  void put(int value);
  int get() const;
};
}  // namespace library

struct Pair
{
  int first;
  int second;
};

struct Sink
{
  int value;
};

class Counter
{
public:
  void add(int value)
  {
    total_ += value;
  }

  int total() const
  {
    return total_;
  }

private:
  int total_ = 0;
};

struct Twice
{
  int operator()(int value) const
  {
    return 2 * value;
  }
};

ros::Publisher assigned_value_pub;
ros::Publisher comma_pub;
ros::Publisher filled_vector_pub;
ros::Publisher chosen_pub;
ros::Publisher other_chosen_pub;
ros::Publisher choosing_pub;
ros::Publisher element_pub;
ros::Publisher index_pub;
ros::Publisher size_pub;
ros::Publisher negated_pub;
ros::Publisher through_pointer_pub;
ros::Publisher through_reference_pub;
ros::Publisher through_later_pointer_pub;
ros::Publisher through_const_reference_pub;
ros::Publisher added_pub;
ros::Publisher array_pub;
ros::Publisher stream_pub;
ros::Publisher const_stream_pub;
ros::Publisher range_pub;
ros::Publisher member_pub;
ros::Publisher returned_pub;
ros::Publisher returned_other_pub;
ros::Publisher returned_by_condition_pub;
ros::Publisher filled_pub;
ros::Publisher filled_by_pointer_pub;
ros::Publisher method_pub;
ros::Publisher other_object_pub;
ros::Publisher called_object_pub;
ros::Publisher lambda_pub;
ros::Publisher bound_to_local_pub;
ros::Publisher under_condition_pub;
ros::Publisher counted_under_condition_pub;
ros::Publisher undeclared_last_pub;
ros::Publisher undeclared_pointer_pub;
ros::Publisher undeclared_address_pub;
ros::Publisher undeclared_for_value_pub;
ros::Publisher undeclared_unchanged_pub;
ros::Publisher library_reference_pub;
ros::Publisher library_constant_pub;
ros::Publisher library_object_pub;
ros::Publisher std_function_pub;
ros::Publisher through_method_reference_pub;
ros::Publisher decremented_under_condition_pub;
ros::Publisher under_two_conditions_pub;
ros::Publisher in_a_case_pub;
ros::Publisher as_often_pub;
ros::Publisher returned_afterwards_pub;
ros::Publisher before_condition_pub;
ros::Publisher returned_in_any_case_pub;
ros::Publisher under_another_condition_pub;
bool g_on = true;
const int g_table[] = {1, 2, 3};

int count()
{
  return 1;
}

int twice(int value)
{
  return 2 * value;
}

int second(int, int value)
{
  return value;
}

int isLarge(int value)
{
  if (value > 100)
    return 1;
  return 0;
}

int limited(int value)
{
  if (value > 100)
    return 1;
  int result = count();
  return result;
}

int steady(int value)
{
  if (value > 100)
    ROS_INFO("large");
  return 1;
}

void fill(int from, int& to)
{
  to = from;
}

void fillPointer(int from, int* to)
{
  *to = from;
}

void keep(const int& old, int value)
{
}

void onIn(const std_msgs::Int32& in)
{
  {
    std_msgs::Int32 out;
    int kept;
    out.data = (kept = in.data);
    assigned_value_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    out.data = (count(), in.data);
    comma_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    undeclared::Vector vector(2);
    vector << in.data, count();
    out.data = vector.norm();
    filled_vector_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    out.data = g_on ? in.data : 0;
    chosen_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    out.data = g_on ? 0 : in.data;
    other_chosen_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    out.data = in.data > 0 ? count() : 0;
    choosing_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    const int values[] = {in.data};
    out.data = values[count()];
    element_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    out.data = g_table[in.data];
    index_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    out.data = sizeof(in.data);
    size_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    out.data = -in.data;
    negated_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    int value = 0;
    int* pointer = &value;
    *pointer = in.data;
    out.data = value;
    through_pointer_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    int value = 0;
    int& reference = value;
    reference = in.data;
    out.data = value;
    through_reference_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    int value = 0;
    int* pointer;
    pointer = &value;
    *pointer = in.data;
    out.data = value;
    through_later_pointer_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    int value = 0;
    const int& reference = value;
    keep(reference, in.data);
    out.data = value;
    through_const_reference_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    int value = 0;
    value += in.data;
    out.data = value;
    added_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    int values[2];
    values[0] = in.data;
    out.data = values[1];
    array_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    std::stringstream stream;
    stream << in.data;
    stream >> out.data;
    stream_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    const Sink sink;
    sink << in.data;
    out.data = sink.value;
    const_stream_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    for (int each : {in.data})
      out.data = each;
    range_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    Pair pair;
    pair.first = in.data;
    out.data = pair.second;
    member_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    out.data = twice(in.data);
    returned_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    out.data = second(in.data, 1);
    returned_other_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    out.data = isLarge(in.data);
    returned_by_condition_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    int value = 0;
    fill(in.data, value);
    out.data = value;
    filled_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    int value = 0;
    fillPointer(in.data, &value);
    out.data = value;
    filled_by_pointer_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    Counter counter;
    counter.add(in.data);
    out.data = counter.total();
    method_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    Counter counter, other;
    other.add(in.data);
    out.data = counter.total();
    other_object_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    Twice functor;
    out.data = functor(in.data);
    called_object_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    auto function = [](int value) { return value; };
    out.data = function(in.data);
    lambda_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    int value = 0;
    auto function = [&]() { value = in.data; };
    function();
    out.data = value;
    bound_to_local_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    int value = 0;
    if (in.data > 0)
      value = count();
    out.data = value;
    under_condition_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    int value = 0;
    if (in.data > 0)
      value++;
    out.data = value;
    counted_under_condition_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    int value = 0;
    undeclared::convert(in.data, value);
    out.data = value;
    undeclared_last_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    int value = 0;
    int* pointer = &value;
    undeclared::convert(*pointer, in.data);
    out.data = value;
    undeclared_pointer_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    int value = 0;
    int failed = undeclared::convert(&value, in.data);
    out.data = value;
    undeclared_address_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    out.data = undeclared::twice(in.data);
    undeclared_for_value_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    int value = 0;
    int other = undeclared::twice(in.data, value);
    out.data = value;
    undeclared_unchanged_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    int value = 0;
    library::convert(in.data, value);
    out.data = value;
    library_reference_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    int value = 0;
    library::print(in.data, value);
    out.data = value;
    library_constant_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    library::Box box;
    box.put(in.data);
    out.data = box.get();
    library_object_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    std::function<int(int)> function = twice;
    out.data = function(in.data);
    std_function_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    Counter counter;
    Counter& reference = counter;
    reference.add(in.data);
    out.data = counter.total();
    through_method_reference_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    int value = 9;
    if (in.data > 0)
      value--;
    out.data = value;
    decremented_under_condition_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    int value = 0;
    if (in.data > 0)
    {
      if (g_on)
        value = count();
    }
    out.data = value;
    under_two_conditions_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    int value = 0;
    switch (in.data)
    {
      case 1:
        value = count();
        break;
      default:
        break;
    }
    out.data = value;
    in_a_case_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    int value = 0;
    for (int i = 0; i < in.data; ++i)
      value += count();
    out.data = value;
    as_often_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    out.data = limited(in.data);
    returned_afterwards_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    int value = count();
    if (in.data > 0)
      ROS_INFO("positive");
    out.data = value;
    before_condition_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    out.data = steady(in.data);
    returned_in_any_case_pub.publish(out);
  }
  {
    std_msgs::Int32 out;
    int value = 0;
    if (g_on)
      value = count();
    out.data = value;
    under_another_condition_pub.publish(out);
  }
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "ways");
  ros::NodeHandle nh;
  assigned_value_pub = nh.advertise<std_msgs::Int32>("/assigned_value", 1);
  comma_pub = nh.advertise<std_msgs::Int32>("/comma", 1);
  filled_vector_pub = nh.advertise<std_msgs::Int32>("/filled_vector", 1);
  chosen_pub = nh.advertise<std_msgs::Int32>("/chosen", 1);
  other_chosen_pub = nh.advertise<std_msgs::Int32>("/other_chosen", 1);
  choosing_pub = nh.advertise<std_msgs::Int32>("/choosing", 1);
  element_pub = nh.advertise<std_msgs::Int32>("/element", 1);
  index_pub = nh.advertise<std_msgs::Int32>("/index", 1);
  size_pub = nh.advertise<std_msgs::Int32>("/size", 1);
  negated_pub = nh.advertise<std_msgs::Int32>("/negated", 1);
  through_pointer_pub = nh.advertise<std_msgs::Int32>("/through_pointer", 1);
  through_reference_pub = nh.advertise<std_msgs::Int32>("/through_reference", 1);
  through_later_pointer_pub = nh.advertise<std_msgs::Int32>("/through_later_pointer", 1);
  through_const_reference_pub = nh.advertise<std_msgs::Int32>("/through_const_reference", 1);
  added_pub = nh.advertise<std_msgs::Int32>("/added", 1);
  array_pub = nh.advertise<std_msgs::Int32>("/array", 1);
  stream_pub = nh.advertise<std_msgs::Int32>("/stream", 1);
  const_stream_pub = nh.advertise<std_msgs::Int32>("/const_stream", 1);
  range_pub = nh.advertise<std_msgs::Int32>("/range", 1);
  member_pub = nh.advertise<std_msgs::Int32>("/member", 1);
  returned_pub = nh.advertise<std_msgs::Int32>("/returned", 1);
  returned_other_pub = nh.advertise<std_msgs::Int32>("/returned_other", 1);
  returned_by_condition_pub = nh.advertise<std_msgs::Int32>("/returned_by_condition", 1);
  filled_pub = nh.advertise<std_msgs::Int32>("/filled", 1);
  filled_by_pointer_pub = nh.advertise<std_msgs::Int32>("/filled_by_pointer", 1);
  method_pub = nh.advertise<std_msgs::Int32>("/method", 1);
  other_object_pub = nh.advertise<std_msgs::Int32>("/other_object", 1);
  called_object_pub = nh.advertise<std_msgs::Int32>("/called_object", 1);
  lambda_pub = nh.advertise<std_msgs::Int32>("/lambda", 1);
  bound_to_local_pub = nh.advertise<std_msgs::Int32>("/bound_to_local", 1);
  under_condition_pub = nh.advertise<std_msgs::Int32>("/under_condition", 1);
  counted_under_condition_pub = nh.advertise<std_msgs::Int32>("/counted_under_condition", 1);
  undeclared_last_pub = nh.advertise<std_msgs::Int32>("/undeclared_last", 1);
  undeclared_pointer_pub = nh.advertise<std_msgs::Int32>("/undeclared_pointer", 1);
  undeclared_address_pub = nh.advertise<std_msgs::Int32>("/undeclared_address", 1);
  undeclared_for_value_pub = nh.advertise<std_msgs::Int32>("/undeclared_for_value", 1);
  undeclared_unchanged_pub = nh.advertise<std_msgs::Int32>("/undeclared_unchanged", 1);
  library_reference_pub = nh.advertise<std_msgs::Int32>("/library_reference", 1);
  library_constant_pub = nh.advertise<std_msgs::Int32>("/library_constant", 1);
  library_object_pub = nh.advertise<std_msgs::Int32>("/library_object", 1);
  std_function_pub = nh.advertise<std_msgs::Int32>("/std_function", 1);
  through_method_reference_pub = nh.advertise<std_msgs::Int32>("/through_method_reference", 1);
  decremented_under_condition_pub = nh.advertise<std_msgs::Int32>("/decremented_under_condition", 1);
  under_two_conditions_pub = nh.advertise<std_msgs::Int32>("/under_two_conditions", 1);
  in_a_case_pub = nh.advertise<std_msgs::Int32>("/in_a_case", 1);
  as_often_pub = nh.advertise<std_msgs::Int32>("/as_often", 1);
  returned_afterwards_pub = nh.advertise<std_msgs::Int32>("/returned_afterwards", 1);
  before_condition_pub = nh.advertise<std_msgs::Int32>("/before_condition", 1);
  returned_in_any_case_pub = nh.advertise<std_msgs::Int32>("/returned_in_any_case", 1);
  under_another_condition_pub = nh.advertise<std_msgs::Int32>("/under_another_condition", 1);
  ros::Subscriber sub = nh.subscribe("/in", 1, onIn);
  ros::spin();
}
