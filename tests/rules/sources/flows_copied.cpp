// A filter: what it receives goes out, through a local variable and a helper; the threshold only decides.
//
// expect: port_flow([_, _, "/in"], [_, _, "/out"], "data", "reactive")
// expect: port_flow([_, _, "/limit"], [_, _, "/out"], "control", "kept")
// expect: flow_variable([_, _, "/limit"], [_, _, "/out"], "Filter::limit_")
// expect: field_flow([_, _, "/in"], "data", [_, _, "/out"], "data")
// expect: Count = count : { port_flow(_, _, _, _) }, Count = 2
// expect-not: flow_always(_, _, _)
// expect: N = count : { _result(_, _) }, N = 7
#include <ros/ros.h>
#include <std_msgs/Float32.h>

class Filter
{
public:
  Filter()
  {
    in_ = nh_.subscribe("/in", 1, &Filter::onIn, this);
    limit_sub_ = nh_.subscribe("/limit", 1, &Filter::onLimit, this);
    out_ = nh_.advertise<std_msgs::Float32>("/out", 1);
  }

private:
  void onIn(const std_msgs::Float32::ConstPtr& msg)
  {
    if (msg->data < limit_)
      return;
    std_msgs::Float32 smooth;
    smooth.data = half(msg->data);
    out_.publish(smooth);
  }
  void onLimit(const std_msgs::Float32& limit) { limit_ = limit.data; }
  static float half(float value) { return value / 2; }

  ros::NodeHandle nh_;
  ros::Subscriber in_, limit_sub_;
  ros::Publisher out_;
  float limit_ = 0;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "filter");
  Filter filter;
  ros::spin();
}
