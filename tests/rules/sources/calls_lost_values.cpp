// Functions that are given away, and do not come back: what is called is another function, or one that nobody knows.
//
// expect-not: calls(_, F), function_name(F, Name), match("never.*", Name)
// expect: Count = count : { function_value(E, F), function_name(F, Name), match("never.*", Name) }, Count = 12
// expect: Count = count : { function_holder(V, F), function_name(F, Name), match("never.*", Name) }, Count = 3
// expect: Count = count : { calls(C, F), function_name(F, "byReference") }, Count = 1
// expect: Count = count : { calls(C, F), function_name(F, "byThen") }, Count = 1
// expect: Count = count : { calls(C, F), function_name(F, "byElse") }, Count = 1
// expect: Count = count : { bound_argument(F, I, A) }, Count = 2
// expect: bound_argument(F, 0, A), function_name(F, "Worker::work"), literal(A, _, "5")
// expect: bound_argument(F, 0, A), function_name(F, "byThread"), literal(A, _, "6")
// expect-not: calls(_, F), function_name(F, "elsewhere")
// expect: reactive /in -> /out may if "!(g_foreign == neverCompared)"
// expect: publisher /out std_msgs/Empty queue=1
// expect: subscriber /in std_msgs/Empty queue=1 callback=onMessage
// expect-only: *
#include <functional>
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <thread>
#include <vector>

typedef void (*Action)();

// of other libraries
struct Pool
{
  void post(Action action);
  void submit(Action action, int priority);
};
Action translate(Action action);
void* symbol(const char* name);
void elsewhere();
extern Action g_foreign;
extern Action g_table[4];

ros::Publisher g_pub;
Pool g_pool;
Action g_override = nullptr;

void neverTranslated() {}
void neverPosted() {}
void neverSubmitted() {}
void neverCompared() {}
void neverPopped() {}
void neverFirst() {}
void neverAsked() {}
void byReference() {}
void byThen() {}
void byElse() {}
void byThread(int) {}

struct Actions : std::vector<Action>
{
  Action fallback() const;
};

struct Choice
{
  Action preferred;
  Action other;
};

struct Worker
{
  void work(int) {}
};

void onMessage(const std_msgs::Empty&)
{
  Action translated = translate(neverTranslated);
  translated();

  g_pool.post(neverPosted);
  g_pool.submit(neverSubmitted, 7);

  if (g_foreign == neverCompared)
    return;
  (*g_foreign)();
  g_table[0]();

  Action found = reinterpret_cast<Action>(symbol("run"));
  found();

  Actions actions;
  actions.push_back(neverPopped);
  Action fallback = actions.fallback();
  fallback();

  Choice choice = {neverFirst, g_foreign};
  choice.other();

  std::function<void()> reference = byReference;
  std::function<void()>* pointer = &reference;
  (*pointer)();

  Action asked = neverAsked;
  Action chosen = asked ? byThen : byElse;
  chosen();

  Action external = elsewhere;
  external();
  std::function<void()> wrapped = elsewhere;
  wrapped();

  g_pub.publish(std_msgs::Empty());
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  g_pub = nh.advertise<std_msgs::Empty>("/out", 1);
  ros::Subscriber sub = nh.subscribe("/in", 1, onMessage);
  Worker worker;
  std::thread thread(&Worker::work, &worker, 5);
  std::thread other(byThread, 6);
  ros::spin();
}
