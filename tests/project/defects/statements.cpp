// A port in any statement.
#include <functional>
#include <vector>

#include <ros/ros.h>
#include <std_msgs/String.h>

typedef std_msgs::String M;

int main(int argc, char** argv)
{
  ros::init(argc, argv, "statements");
  ros::NodeHandle nh;
  switch (argc)
  {
    case 1:
      nh.advertise<M>("switch", 1);  // expect: publisher switch std_msgs/String
      break;
    default:
      break;
  }
  for (int i = 0; i < 1; ++i)
    nh.advertise<M>("for", 1);  // expect: publisher for
  do
  {
    nh.advertise<M>("do", 1);  // expect: publisher do
  } while (argc > 2);
  std::vector<int> values(2);
  for (int value : values)
    nh.advertise<M>("range", 1);  // expect: publisher range
  try
  {
    nh.advertise<M>("try", 1);  // expect: publisher try
  }
  catch (const std::exception& e)
  {
    nh.advertise<M>("catch", 1);  // expect: publisher catch
  }
  auto lambda = [&]() { nh.advertise<M>("lambda", 1); };  // expect: publisher lambda
  lambda();
  std::function<void()> function = [&]() { nh.advertise<M>("function", 1); };  // expect: publisher function
  function();
  argc > 1 ? (void)nh.advertise<M>("ternary", 1) : (void)0;  // expect: publisher ternary
}
