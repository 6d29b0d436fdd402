// A message that is filled by a loop over its own parts is data: how many parts it has decides nothing but what becomes of these. What
// decides which message is sent in each round is state.
//
// expect: state_variable("Mapper::mode_")
// expect: 1 = count : { state_variable(_) }
#include <nav_msgs/OccupancyGrid.h>
#include <ros/ros.h>
#include <std_msgs/String.h>

class Mapper
{
public:
  Mapper() : grid_pub_(nh_.advertise<nav_msgs::OccupancyGrid>("grid", 1)), mode_pub_(nh_.advertise<std_msgs::String>("mode", 1)) {}

  void spin()
  {
    ros::Rate rate(10);
    while (ros::ok()) {
      grid_.data.resize(size());
      for (size_t i = 0; i < grid_.data.size(); ++i) grid_.data[i] = 1;
      grid_pub_.publish(grid_);
      std_msgs::String mode;
      if (mode_ == 0) {
        mode.data = "searching";
        mode_ = 1;
      } else {
        mode.data = "found";
        mode_ = 0;
      }
      mode_pub_.publish(mode);
      rate.sleep();
    }
  }

private:
  size_t size() const { return static_cast<size_t>(ros::Time::now().toSec()) % 100; }
  ros::NodeHandle nh_;
  nav_msgs::OccupancyGrid grid_;
  ros::Publisher grid_pub_, mode_pub_;
  int mode_ = 0;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "mapper");
  Mapper mapper;
  mapper.spin();
}
