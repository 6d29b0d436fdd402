#include <delivery_msgs/Parcel.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>

// The box on the robot: its lid, and the parcel that was put in.
class ParcelBox
{
public:
  ParcelBox() : private_nh_("~")
  {
    private_nh_.param("open_seconds", open_seconds_, 20.0);
    private_nh_.param<std::string>("door", door_, "");
    parcel_pub_ = nh_.advertise<delivery_msgs::Parcel>("parcel", 5);
    open_server_ = nh_.advertiseService("open_boxes", &ParcelBox::onOpen, this);  // expect: service_server open_boxes
  }

private:
  bool onOpen(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response)
  {
    ros::Duration(open_seconds_).sleep();
    delivery_msgs::Parcel parcel;
    parcel.door = door_;
    parcel_pub_.publish(parcel);  // expect: reactive open_boxes -> parcel must
    response.success = true;
    return true;
  }

  ros::NodeHandle nh_;
  ros::NodeHandle private_nh_;
  ros::Publisher parcel_pub_;
  ros::ServiceServer open_server_;
  double open_seconds_;
  std::string door_;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "parcel_box");
  ParcelBox box;
  ros::spin();
  return 0;
}
