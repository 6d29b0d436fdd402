// Functions that pass on names and node handles, and make a port in one of two branches: the ports are those of the calls.
//
// expect: publisher out std_msgs/Bool
// expect: publisher ~old_out std_msgs/Bool
// expect: port_made_for([_, "publisher", "out"], C), location(C, _, 39, _)
// expect: port_made_for([_, "publisher", "~old_out"], C), location(C, _, 39, _)
// expect: port_made_for([_, "publisher", "other"], C), location(C, _, 40, _)
// expect-not: port_made_for([_, "publisher", "twice"], _)
// expect-not: port_made_for([_, "publisher", "own"], _)
#include <ros/ros.h>
#include <std_msgs/Bool.h>

template <class M>
ros::Publisher advertise(ros::NodeHandle & nh, const std::string & name, ros::NodeHandle & nh_old, const std::string & name_old, bool old)
{
  if (old) {
    return nh_old.advertise<M>(name_old, 1);
  } else {
    return nh.advertise<M>(name, 1);
  }
}

class Own
{
public:
  ros::Publisher make(const std::string & name) {return nh_.advertise<std_msgs::Bool>(name, 1);}

private:
  ros::NodeHandle nh_;
};

int main(int argc, char ** argv)
{
  ros::init(argc, argv, "branches");
  ros::NodeHandle nh;
  ros::NodeHandle pnh("~");
  bool old = false;
  pnh.param("old", old, old);
  ros::Publisher first = advertise<std_msgs::Bool>(nh, "out", pnh, "old_out", old);
  ros::Publisher second = advertise<std_msgs::Bool>(nh, "other", pnh, "old_other", old);
  ros::Publisher third = advertise<std_msgs::Bool>(nh, "twice", pnh, "twice_old", old);
  ros::Publisher fourth = advertise<std_msgs::Bool>(nh, "twice", pnh, "twice_old", old);
  Own own;
  ros::Publisher fifth = own.make("own");
  ros::spin();
}
