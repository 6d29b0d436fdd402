// Loops that wait in some of their rounds: what they wait for then does not tell how often they go round; where every round waits somewhere, it does.
//
// expect: round_unpaced(C), location(C, _, 26, _)
// expect: Count = count : { round_unpaced(C) }, Count = 1
// expect: periodic(C, _, "sleep"), location(C, _, 26, _)
// expect-not: period(C, _, _, _), location(C, _, 26, _)
// expect: period(C, "10", 0, ""), location(C, _, 38, _)
#include <ros/ros.h>
#include <std_msgs/Empty.h>

struct Serial
{
  bool isOpen();
  void open();
  bool available();
};

void listen(ros::Publisher& pub, Serial& serial)
{
  while (ros::ok())
  {
    if (!serial.isOpen())
    {
      serial.open();
      // wait for the board to start
      ros::Duration(5.0).sleep();
    }
    if (serial.available()) pub.publish(std_msgs::Empty());
  }
}

void poll(ros::Publisher& pub, Serial& serial)
{
  ros::Rate rate(10);
  while (ros::ok())
  {
    if (!serial.isOpen())
      rate.sleep();
    else
    {
      pub.publish(std_msgs::Empty());
      ros::spinOnce();
      rate.sleep();
    }
  }
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  ros::Publisher pub = nh.advertise<std_msgs::Empty>("out", 1);
  Serial serial;
  if (argc > 1) listen(pub, serial);
  poll(pub, serial);
}
