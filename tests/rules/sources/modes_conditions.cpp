// What a node does in a mode, by the conditions of its callbacks: whether it ignores a message, answers it, or goes on to another mode.
//
// expect: ignores([_, _, "/asked"], "g_mode", "Mode::DONE")
// expect: ignores([_, _, "/asked"], "g_mode", "Mode::IDLE")
// expect: ignores([_, _, "/both"], "g_mode", "Mode::DONE")
// expect: ignores([_, _, "/both"], "g_mode", "Mode::IDLE")
// expect: ignores([_, _, "/default"], "g_mode", "Mode::DONE")
// expect: ignores([_, _, "/default"], "g_mode", "Mode::IDLE")
// expect: ignores([_, _, "/early"], "g_mode", "Mode::DONE")
// expect: ignores([_, _, "/early"], "g_mode", "Mode::IDLE")
// expect: ignores([_, _, "/either"], "g_mode", "Mode::IDLE")
// expect: ignores([_, _, "/equal"], "g_mode", "Mode::DONE")
// expect: ignores([_, _, "/equal"], "g_mode", "Mode::IDLE")
// expect: ignores([_, _, "/equal_on_the_left"], "g_mode", "Mode::DONE")
// expect: ignores([_, _, "/equal_on_the_left"], "g_mode", "Mode::IDLE")
// expect: ignores([_, _, "/function"], "g_mode", "Mode::DONE")
// expect: ignores([_, _, "/function"], "g_mode", "Mode::IDLE")
// expect: ignores([_, _, "/logged"], "g_mode", "Mode::DONE")
// expect: ignores([_, _, "/logged"], "g_mode", "Mode::IDLE")
// expect: ignores([_, _, "/moves"], "g_mode", "Mode::BUSY")
// expect: ignores([_, _, "/moves"], "g_mode", "Mode::IDLE")
// expect: ignores([_, _, "/moves_on"], "g_mode", "Mode::DONE")
// expect: ignores([_, _, "/negated"], "g_mode", "Mode::BUSY")
// expect: ignores([_, _, "/neither"], "g_mode", "Mode::BUSY")
// expect: ignores([_, _, "/neither"], "g_mode", "Mode::DONE")
// expect: ignores([_, _, "/not_both"], "g_mode", "Mode::BUSY")
// expect: ignores([_, _, "/off"], "g_on", "true")
// expect: ignores([_, _, "/on"], "g_on", "false")
// expect: ignores([_, _, "/switched"], "g_mode", "Mode::BUSY")
// expect: ignores([_, _, "/unequal"], "g_mode", "Mode::BUSY")
// expect: Count = count : { ignores(_, _, _) }, Count = 28
// expect: moves_on([_, _, "/moves"], "g_mode", "Mode::DONE", "Mode::IDLE")
// expect: moves_on([_, _, "/moves_on"], "g_mode", "Mode::BUSY", "Mode::DONE")
// expect: moves_on([_, _, "/moves_on"], "g_mode", "Mode::IDLE", "Mode::BUSY")
// expect: moves_on([_, _, "/sets_off"], "g_on", "true", "false")
// expect: moves_on([_, _, "/sets_on"], "g_on", "false", "true")
// expect: Count = count : { moves_on(_, _, _, _) }, Count = 5
// expect: moves_freely("g_mode", "Mode::DONE", "Mode::IDLE")
// expect: Count = count : { moves_freely(_, _, _) }, Count = 1
// expect: answers_in([_, _, "/asked"], [_, _, "/out"], "g_mode", "Mode::BUSY")
// expect: answers_in([_, _, "/counted"], [_, _, "/out"], "g_mode", "Mode::BUSY")
// expect: answers_in([_, _, "/default"], [_, _, "/out"], "g_mode", "Mode::BUSY")
// expect: answers_in([_, _, "/early"], [_, _, "/out"], "g_mode", "Mode::BUSY")
// expect: answers_in([_, _, "/either"], [_, _, "/out"], "g_mode", "Mode::BUSY")
// expect: answers_in([_, _, "/either"], [_, _, "/out"], "g_mode", "Mode::DONE")
// expect: answers_in([_, _, "/either_other"], [_, _, "/out"], "g_mode", "Mode::BUSY")
// expect: answers_in([_, _, "/equal"], [_, _, "/out"], "g_mode", "Mode::BUSY")
// expect: answers_in([_, _, "/equal_on_the_left"], [_, _, "/out"], "g_mode", "Mode::BUSY")
// expect: answers_in([_, _, "/function"], [_, _, "/out"], "g_mode", "Mode::BUSY")
// expect: answers_in([_, _, "/in_function"], [_, _, "/out"], "g_mode", "Mode::BUSY")
// expect: answers_in([_, _, "/logged"], [_, _, "/out"], "g_mode", "Mode::BUSY")
// expect: answers_in([_, _, "/negated"], [_, _, "/out"], "g_mode", "Mode::DONE")
// expect: answers_in([_, _, "/negated"], [_, _, "/out"], "g_mode", "Mode::IDLE")
// expect: answers_in([_, _, "/neither"], [_, _, "/out"], "g_mode", "Mode::IDLE")
// expect: answers_in([_, _, "/not_both"], [_, _, "/out"], "g_mode", "Mode::DONE")
// expect: answers_in([_, _, "/not_both"], [_, _, "/out"], "g_mode", "Mode::IDLE")
// expect: answers_in([_, _, "/off"], [_, _, "/out"], "g_on", "false")
// expect: answers_in([_, _, "/on"], [_, _, "/out"], "g_on", "true")
// expect: answers_in([_, _, "/switched"], [_, _, "/out"], "g_mode", "Mode::IDLE")
// expect: answers_in([_, _, "/unclear_case"], [_, _, "/out"], "g_mode", "Mode::BUSY")
// expect: answers_in([_, _, "/unequal"], [_, _, "/out"], "g_mode", "Mode::DONE")
// expect: answers_in([_, _, "/unequal"], [_, _, "/out"], "g_mode", "Mode::IDLE")
// expect: Count = count : { answers_in(_, _, _, _) }, Count = 23
// expect: Count = count : { asks_for(_, _, _) }, Count = 19
// expect: Count = count : { asks_for(_, "g_on", "true") }, Count = 1
// expect: Count = count : { never_is(_, "g_mode", "Mode::BROKEN") }, Count = 2
// expect: Count = count : { never_is(_, _, _) }, Count = 2
#include <ros/ros.h>
#include <std_msgs/Bool.h>

enum Mode { IDLE, BUSY, DONE, BROKEN };

Mode g_mode = IDLE;
bool g_on = false;
int g_any = 0;
int g_count = 0;
const Mode g_constant = DONE;
ros::Publisher g_pub;

bool isBusy()
{
  return g_mode == BUSY;
}

bool isBusyOr(bool other)
{
  if (other)
    return true;
  return g_mode == BUSY;
}

bool other(bool value)
{
  return !value;
}

void sendWhenBusy(const std_msgs::Bool& message)
{
  if (g_mode == BUSY)
    g_pub.publish(message);
}

void onEqual(const std_msgs::Bool& message)
{
  if (g_mode == BUSY)
    g_pub.publish(message);
}

void onEqualOnTheLeft(const std_msgs::Bool& message)
{
  if (BUSY == g_mode)
    g_pub.publish(message);
}

void onUnequal(const std_msgs::Bool& message)
{
  if (g_mode != BUSY)
    g_pub.publish(message);
}

void onNegated(const std_msgs::Bool& message)
{
  if (!(g_mode == BUSY))
    g_pub.publish(message);
}

void onBoth(const std_msgs::Bool& message)
{
  if (message.data && g_mode == BUSY)
    g_pub.publish(message);
}

void onEither(const std_msgs::Bool& message)
{
  if (g_mode == BUSY || g_mode == DONE)
    g_pub.publish(message);
}

void onEitherOther(const std_msgs::Bool& message)
{
  if (g_mode == BUSY || message.data)
    g_pub.publish(message);
}

void onNeither(const std_msgs::Bool& message)
{
  if (!(g_mode == BUSY || g_mode == DONE))
    g_pub.publish(message);
}

void onNotBoth(const std_msgs::Bool& message)
{
  if (!(g_mode != IDLE && g_mode != DONE))
    g_pub.publish(message);
}

void onEarly(const std_msgs::Bool& message)
{
  if (g_mode != BUSY)
    return;
  g_pub.publish(message);
}

void onFunction(const std_msgs::Bool& message)
{
  if (isBusy())
    g_pub.publish(message);
}

void onFunctionOfSeveral(const std_msgs::Bool& message)
{
  if (isBusyOr(message.data))
    g_pub.publish(message);
}

void onSwitched(const std_msgs::Bool& message)
{
  switch (g_mode)
  {
    case IDLE:
      g_pub.publish(message);
      break;
    case BUSY:
      ROS_INFO("busy");
      break;
    default:
      g_pub.publish(message);
  }
}

void onDefault(const std_msgs::Bool& message)
{
  switch (g_mode)
  {
    case BUSY:
      g_pub.publish(message);
      break;
    default:
      break;
  }
}

void onUnclearCase(const std_msgs::Bool& message)
{
  switch (g_mode)
  {
    case BUSY:
    case g_constant:
      g_pub.publish(message);
  }
}

void onOn(const std_msgs::Bool& message)
{
  if (g_on)
    g_pub.publish(message);
}

void onOff(const std_msgs::Bool& message)
{
  if (!g_on)
    g_pub.publish(message);
}

void onLogged(const std_msgs::Bool& message)
{
  if (g_mode == BUSY)
    g_pub.publish(message);
  else
    ROS_INFO("ignored");
}

void onCounted(const std_msgs::Bool& message)
{
  if (g_mode == BUSY)
    g_pub.publish(message);
  else
    ++g_count;
}

void onAsked(const std_msgs::Bool& message)
{
  if (g_mode == BUSY)
    g_pub.publish(message);
  else if (other(message.data))
    return;
}

void onInFunction(const std_msgs::Bool& message)
{
  sendWhenBusy(message);
}

void onAnything(const std_msgs::Bool& message)
{
  if (g_any == 1)
    g_pub.publish(message);
}

void onNever(const std_msgs::Bool& message)
{
  if (g_mode == BROKEN)
    g_pub.publish(message);
}

void onNeverSwitched(const std_msgs::Bool& message)
{
  switch (g_mode)
  {
    case BROKEN:
      g_pub.publish(message);
  }
}

void onMoves(const std_msgs::Bool& message)
{
  if (g_mode == DONE)
    g_mode = IDLE;
}

void onMovesOn(const std_msgs::Bool& message)
{
  if (g_mode == IDLE)
    g_mode = BUSY;
  else if (g_mode == BUSY)
    g_mode = DONE;
}

void onSetsOn(const std_msgs::Bool& message)
{
  g_on = true;
}

void onSetsOff(const std_msgs::Bool& message)
{
  g_on = false;
}

void onSetsAnything(const std_msgs::Bool& message)
{
  g_any = message.data;
}

void onTimer(const ros::TimerEvent&)
{
  if (g_mode == DONE)
    g_mode = IDLE;
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "modes");
  ros::NodeHandle nh;
  g_pub = nh.advertise<std_msgs::Bool>("/out", 1);
  ros::Subscriber subs[] = {
    nh.subscribe("/equal", 1, onEqual),
    nh.subscribe("/equal_on_the_left", 1, onEqualOnTheLeft),
    nh.subscribe("/unequal", 1, onUnequal),
    nh.subscribe("/negated", 1, onNegated),
    nh.subscribe("/both", 1, onBoth),
    nh.subscribe("/either", 1, onEither),
    nh.subscribe("/either_other", 1, onEitherOther),
    nh.subscribe("/neither", 1, onNeither),
    nh.subscribe("/not_both", 1, onNotBoth),
    nh.subscribe("/early", 1, onEarly),
    nh.subscribe("/function", 1, onFunction),
    nh.subscribe("/function_of_several", 1, onFunctionOfSeveral),
    nh.subscribe("/switched", 1, onSwitched),
    nh.subscribe("/default", 1, onDefault),
    nh.subscribe("/unclear_case", 1, onUnclearCase),
    nh.subscribe("/on", 1, onOn),
    nh.subscribe("/off", 1, onOff),
    nh.subscribe("/logged", 1, onLogged),
    nh.subscribe("/counted", 1, onCounted),
    nh.subscribe("/asked", 1, onAsked),
    nh.subscribe("/in_function", 1, onInFunction),
    nh.subscribe("/anything", 1, onAnything),
    nh.subscribe("/never", 1, onNever),
    nh.subscribe("/never_switched", 1, onNeverSwitched),
    nh.subscribe("/moves", 1, onMoves),
    nh.subscribe("/moves_on", 1, onMovesOn),
    nh.subscribe("/sets_on", 1, onSetsOn),
    nh.subscribe("/sets_off", 1, onSetsOff),
    nh.subscribe("/sets_anything", 1, onSetsAnything),
  };
  ros::Timer timer = nh.createTimer(ros::Duration(1.0), onTimer);
  ros::spin();
}
