// Ordinary code: classes, templates, lambdas, containers, texts, loops and choices in their common forms. It reads, calculates and sends, and there is nothing
// else in it of what rules look for.
//
// expect: publisher /answer std_msgs/Int32 queue=1
// expect: subscriber /number std_msgs/Int32 queue=1 callback=onNumber
// expect: reactive /number -> /answer must
// expect-only: *
// expect: Given = count : { as_given(_, _, _) }, Made = count : { _result(_, _) }, Given = 25, Made = 35
// expect: Reached = count : { value_reaches(_, _, _) }, Typed = count : { chained_type(_, _) }, Templates = count : { template_argument_for(_, _, _, _) }, Reached = 2, Typed = 1, Templates = 1
// expect: N = count : { _path(_, _, _) }, N = 9, 12 = count : { _local_made_of_parameter(_, _) }, 4 = count : { _goes_back(_, _) }, 2 = count : { touched(_) }
// expect: N = count : { asks_if_empty(_, _) }, N = 1, 1 = count : { decides(_, _) }
//
// waits, timers and starts
// expect-not: _asks_for_arrival(_, _, _); _at_once(_, _, _); _awaited(_); _done_before(_, _); _entered_before(_, _); _limited(_)
// expect-not: _reached_before(_, _); _sent_before(_, _); _skips(_, _); _wait_limit(_, _, _); _waiting_call(_, _); _waits_always(_, _)
// expect-not: _waits_by_call(_); _waits_in(_); _without_limit(_); call_blocks(_, _, _); timer_variable(_, _); waits_for(_, _); _first_value(_, _)
// expect-not: _otherwise_at_first(_); _place_exported(_)
// modes and contradictions
// expect-not: _acting_block(_); _enters_at(_, _); _halts(_, _, _); _halts_before(_, _, _); _holds_until(_, _); _lasts(_); _mode_decides(_, _)
// expect-not: _mode_switch(_, _); _step(_, _, _, _, _); _at_defaults(_); _constant_of(_, _); _constant_return(_, _); _outcome(_, _, _); _tested(_)
// expect-not: _tested_value(_, _, _); _truth_value(_, _); truth_test(_, _, _)
// servers, filters and other ports that libraries make
// expect-not: _answered_to(_, _); _calls_held(_, _, _); _connected(_, _, _); _feeds_directly(_, _); _server_of(_, _); _sink_of(_, _); feeds(_, _)
// expect-not: flow_variable(_, _, _); flows_to_sink(_, _); given_to_field(_, _, _); sink_callback(_, _); implicit_port(_, _)
// expect-not: _implicit(_, _, _, _, _); hidden_site(_, _); hidden_namespace(_, _); port_object(_, _); port_unknown(_, _); port_made_through(_, _)
// expect-not: _sends_other(_, _, _); _data_flow(_, _, _); steps_through(_); may_skip(_, _, _)
// groups of callbacks, and answers
// expect-not: callback_group(_, _); _group_set(_, _); default_group(_, _); _another_group(_); _made_on(_, _); exclusive_group(_); _group_made(_, _)
// expect-not: _made_otherwise(_); _exclusive(_); asks(_, _, _); future_of(_, _); _keeps_future(_, _); _waits(_, _); _wait_time(_, _); _polled(_)
// expect-not: awaits_answer(_, _); _leads_to_wait(_, _); callback_in_group(_, _, _); _handed_by(_, _); _kept_in_group(_)
// expect-not: _called_for_parameters(_, _); answer_kept_out(_, _, _); _waits_for_answer(_, _); _waits_earlier(_, _, _, _); _answer_for(_, _, _)
// expect-not: _kept_out(_, _); _one_node(_, _); _in_one_thread(_, _); _runs_callbacks(_); _served_with_node(_); _served_apart(_); _group_call(_)
// expect-not: executor_of_threads(_)
// qualities
// expect-not: _calls_quality(_, _); _profile(_, _); _entry_call(_, _, _); port_quality(_, _, _); quality(_, _, _, _)
// functions that hand on
// expect-not: chained_role(_, _, _); _called_inside(_, _); captured(_, _, _); _other_callee(_, _); _generic_type(_, _); _types(_, _)
// expect-not: template_made_with(_, _); call_unfit(_, _); _typed_role(_); twin_port(_, _, _, _, _, _); _twin_name(_); _context_has_instance(_, _); _leaves(_, _, _)
// expect-not: _passes(_, _, _)
// names and texts
// expect-not: _asked(_, _); _asks(_, _, _); _asks_for(_, _); _folder(_, _); _relative(_); _wanted_join(_, _); calculation(_, _, _, _)
// expect-not: calculation_values(_, _, _, _, _, _); joined_text(_, _, _); names_namespace(_, _); number_variable(_); operand_values(_, _, _, _, _, _)
// expect-not: counted(_); context_call(_, _); entered_from(_, _, _); _not_with(_, _, _, _); garbled(_, _); definition_target(_, _); outer_use(_, _)
// expect-not: captured_parameter_use(_, _, _); recursive_call(_); settled_local(_, _, _); pointer_use(_, _)
// parameters and options
// expect-not: _option_text(_, _); option_declared(_, _); parameter_access_type(_, _, _); parameter_operand_type(_, _); parameter_value(_, _, _)
// expect-not: _chooses(_)
// members
// expect-not: _contains_use(_, _); _in_renewal(_, _); _renewed_in(_, _); _stale(_, _); _value_of_renewal(_); renews(_, _, _); _held(_, _, _)
// expect-not: _held_itself(_, _, _); _held_otherwise(_, _); _made_in(_, _); _node_constructor(_, _); _set_otherwise(_); part_use(_, _, _)
// frames
// expect-not: _frame_of(_, _, _); _inside(_, _)
#include <algorithm>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <ros/ros.h>
#include <std_msgs/Int32.h>
#include <string>
#include <utility>
#include <vector>

enum Mode
{
  IDLE,
  BUSY
};

struct Limits
{
  int low = 0;
  int high;
};

template <class T>
T largest(const std::vector<T>& values, T otherwise)
{
  T found = otherwise;
  for (const T& each : values)
    if (each > found)
      found = each;
  return found;
}

template <class T>
class Box
{
public:
  explicit Box(const T& content) : content_(content) {}
  const T& content() const
  {
    return content_;
  }

private:
  T content_;
};

class Shape
{
public:
  Shape(const std::string& name, int corners) : name_(name), corners_(corners) {}
  virtual ~Shape() {}
  virtual int area() const
  {
    return 0;
  }
  const std::string& name() const
  {
    return name_;
  }

protected:
  std::string name_;
  int corners_;
};

class Square : public Shape
{
public:
  explicit Square(int side) : Shape("square", 4), side_(side) {}
  int area() const override
  {
    return side_ * side_;
  }
  Square& grow(int by = 1)
  {
    side_ += by;
    return *this;
  }

private:
  int side_;
};

static int twice(int number)
{
  return 2 * number;
}

std::pair<int, std::string> described(const Shape& shape)
{
  std::string text = shape.name() + ": " + std::to_string(shape.area());
  return std::make_pair(shape.area(), text);
}

std::unique_ptr<Square> made(int side)
{
  std::unique_ptr<Square> square(new Square(side));
  square->grow().grow(2);
  return square;
}

int calculated(int from, int to)
{
  Limits limits = {from, to};
  limits.low = -limits.low;
  int sum = 0, count = 0;
  int table[3] = {1, 2, 3};
  for (int i = limits.low; i < limits.high; ++i)
  {
    if (i % 3 == 0)
      continue;
    sum += table[i % 3] << 1;
    ++count;
  }
  do
  {
    sum--;
  } while (sum > 100 && count != 0);
  switch (count & 3)
  {
    case IDLE:
      return static_cast<int>(sum / 2.0);
    case BUSY:
      sum = ~sum;
      break;
    default:
      sum = sum > 7 ? sum : -sum;
  }
  return sum;
}

void printed(int number)
{
  std::map<std::string, int> counts;
  counts["a"] = number;
  counts.insert(std::make_pair("b", twice(number)));
  std::function<int(int)> function = twice;
  auto bound = std::bind(twice, number);
  auto add = [number](int other) { return number + other; };
  std::vector<int> numbers = {function(1), bound(), add(2)};
  std::sort(numbers.begin(), numbers.end(), [](int one, int other) { return one < other; });
  for (const auto& each : counts)
    std::cout << each.first << "=" << each.second << std::endl;
  Box<int> box(largest(numbers, 0));
  std::shared_ptr<Shape> shape = std::make_shared<Square>(box.content());
  std::string text = described(*shape).second;
  if (!text.empty() && text[0] != ' ')
    std::cout << text.substr(1) << *made(2)->name().c_str();
  try
  {
    std::cout << counts.at(text);
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what();
  }
}

ros::Publisher g_pub;

void onNumber(const std_msgs::Int32::ConstPtr& message)
{
  printed(message->data);
  std_msgs::Int32 answer;
  answer.data = calculated(0, message->data);
  g_pub.publish(answer);
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "ordinary");
  ros::NodeHandle nh;
  g_pub = nh.advertise<std_msgs::Int32>("/answer", 1);
  ros::Subscriber sub = nh.subscribe("/number", 1, onNumber);
  ros::spin();
}
