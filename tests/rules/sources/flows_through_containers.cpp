// Messages are put into a container by one callback; another sends the element that it is asked for: which one is decided, not what is in it.
//
// expect: port_flow([_, _, "/item"], [_, _, "/chosen"], "data", "kept")
// expect: port_flow([_, _, "/index"], [_, _, "/chosen"], "control", "reactive")
// expect: Count = count : { port_flow(_, _, _, _) }, Count = 2
// expect: Given = count : { as_given(_, _, _) }, Steps = count : { value_step(_, _, _) }, Types = count : { _site_type(_, _) }, Given = 5, Steps = 4, Types = 3
// expect-not: renews(_, _, _); template_argument_for(_, _, _, _); timer_variable(_, _); _enters_at(_, _); _written_argument(_, _, _)
// expect: 5 = count : { type_holds_instance(_, _) }
// expect-not: compares(_, _, _, _, _)
#include <geometry_msgs/Point.h>
#include <ros/ros.h>
#include <std_msgs/Int32.h>
#include <vector>

std::vector<geometry_msgs::Point> items;
ros::Publisher pub;

void onItem(const geometry_msgs::Point::ConstPtr& item) { items.push_back(*item); }

void onIndex(const std_msgs::Int32& index)
{
  if (index.data < 0)
    return;
  const geometry_msgs::Point& point = items[index.data];
  pub.publish(point);
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "chooser");
  ros::NodeHandle nh;
  pub = nh.advertise<geometry_msgs::Point>("/chosen", 1);
  ros::Subscriber item = nh.subscribe("/item", 1, onItem), index = nh.subscribe("/index", 1, onIndex);
  ros::spin();
}
