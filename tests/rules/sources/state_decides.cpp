// Which variables decide what the node does, directly and through locals, getters and structures; and which only look like it.
//
// expect: state level_
// expect: state limit_
// expect: state mode_
// expect: state stage_
// expect: state depth_
// expect: state pose_
// expect: state wanted_
// expect: state far_
// expect: state count_
// expect: state made_
// expect: state list_
// expect: state names_
// expect-only: state
// expect: configuration kind_
// expect-only: configuration
// expect: transition level_ = 2 on /in
// expect: transition mode_ = 3 on /in
// expect: transition limit_ = message.data on /in
// expect: transition stage_ = message.data on /in
// expect: transition depth_ = message.data on /in
// expect: transition pose_ = message.data on /in field=x
// expect: transition wanted_ = message.data on /in
// expect: transition far_ = message.data on /in
// expect: transition count_ on /in
// expect: transition made_ = true on /in
// expect: transition list_ on /settled
// expect: transition names_ on /in
// expect-only: transition
// expect: Count = count : { settled_local(E, Name, Value) }, Count = 7
// expect: settled_local(E, "settled", Value)
// expect: settled_local(E, "first", Value)
// expect: settled_local(E, "second", Value)
// expect: settled_local(E, "size", Value)
// expect: settled_local(E, "local", Value)
// expect: settled_local(E, "scaled", Value)
// expect: settled_local(E, "deep", Value)
// expect: Count = count : { stable_condition(E) }, Count = 1
// expect: N = count : { _result(_, _) }, N = 16
// expect-not: _generic(_, _); _belongs_to(_, _, _)
#include <memory>
#include <ros/ros.h>
#include <sstream>
#include <std_msgs/Int32.h>
#include <vector>

bool measure(int value);

struct Pose
{
  int x, y;
};

class Node;

class Base
{
protected:
  int level_;
};

// what a constructor gives to its own members is no change
class Tracker : public Base
{
public:
  explicit Tracker(Node& node);

  void grow(ros::Publisher& pub, const std_msgs::Int32& message)
  {
    level_ = 2;
    if (level_ > 1)
      pub.publish(message);
  }
};

class Node
{
  friend class Tracker;

public:
  Node()
  {
    pub_ = nh_.advertise<std_msgs::Int32>("/out", 1);
    kind_ = 1;
    sub_ = nh_.subscribe("/in", 1, &Node::onIn, this);
    other_sub_ = nh_.subscribe("/settled", 1, &Node::onSettled, this);
    if (unset_ == 1)
      kind_ = 2;
  }

private:
  int limit() const
  {
    return limit_;
  }

  bool staged() const
  {
    if (stage_ > 2)
      return true;
    return false;
  }

  // one of its parameters does not matter
  bool beyond(int value, int, int threshold)
  {
    ++count_;
    bool result = false;
    if (value > threshold)
      result = true;
    return result;
  }

  void onIn(const std_msgs::Int32& message)
  {
    tracker_.reset(new Tracker(*this));
    tracker_->grow(pub_, message);
    names_.push_back(message.data);
    limit_ = message.data;
    stage_ = message.data;
    depth_ = message.data;
    pose_.x = message.data;
    wanted_ = message.data;
    far_ = message.data;
    idle_ = message.data;
    ignored_ = message.data;
    compared_ = message.data;
    unset_ = message.data;
    touched_ = 2;
    if (mode_ == 3)
      pub_.publish(message);
    if (limit() > 2)
      pub_.publish(message);
    if (staged())
      pub_.publish(message);

    int deep = depth_;
    if (deep + 1 > 2)
      pub_.publish(message);

    Pose pose;
    pose.x = pose_.x;
    pose.y = message.data;
    if (pose.x > 1)
      pub_.publish(message);

    bool flag = false;
    if (wanted_ == 7)
      flag = true;
    if (flag)
      pub_.publish(message);

    if (beyond(far_, ignored_, 4))
      pub_.publish(message);

    int local = message.data;
    bool same = local == compared_;
    ROS_INFO("%d %d", same, idle_);
    if (local > 5)
      pub_.publish(message);
    if (kind_ == 1)
      pub_.publish(message);
    if (kind_ == 1 && !made_)
    {
      made_ = true;
      ++count_;
    }
    if (count_ > 3)
      pub_.publish(message);
  }

  void change(int& number)
  {
    number = 5;
  }

  void onSettled(const std_msgs::Int32& message)
  {
    bool settled = limit_ > 3;
    if (settled)
      pub_.publish(message);

    int first = depth_ + message.data;
    int second = first * 2;
    if (second > 4)
      pub_.publish(message);

    size_t size = names_.size();
    if (size > 1)
      pub_.publish(message);

    int scaled = -limit_;
    if (scaled < -2)
      pub_.publish(message);

    int read = 0;
    std::istringstream("1") >> read;
    if (read > 1)
      pub_.publish(message);

    int passed = limit_;
    change(passed);
    if (passed > 2)
      pub_.publish(message);

    bool measured = measure(limit_);
    if (measured)
      pub_.publish(message);

    int given = 3;
    nh_.getParam("given", given);
    if (given > 3)
      pub_.publish(message);

    Pose moved = pose_;
    moved.x = 4;
    if (moved.x > 2)
      pub_.publish(message);

    int values[] = {1, 2};
    values[0] = limit_;
    int sum = values[0];
    if (sum > 2)
      pub_.publish(message);

    int pushed = list_.back();
    list_.push_back(message.data);
    for (int each : list_)
    {
      if (each > 2)
        pub_.publish(message);
    }
    if (pushed > 2)
      pub_.publish(message);
  }

  ros::NodeHandle nh_;
  ros::Publisher pub_;
  ros::Subscriber sub_, other_sub_;
  int limit_ = 0, mode_ = 0, stage_ = 0, depth_ = 0, wanted_ = 0, far_ = 0, idle_ = 0, ignored_ = 0, compared_ = 0, unset_ = 0, kind_, count_ = 0, touched_ = 0;
  bool made_ = false;
  Pose pose_;
  std::vector<int> list_, names_;
  std::unique_ptr<Tracker> tracker_;
};

Tracker::Tracker(Node& node)
{
  level_ = 1;
  node.mode_ = 3;
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  Node node;
  ros::spin();
}
