// A server of dynamic_reconfigure that an object of a class has: it is in the namespace of the handle that the object is made with.
//
// expect: dynamic_reconfigure_server ~ base_driver/DriverConfig callback=configured
// expect: dynamic_reconfigure_server arm base_driver/DriverConfig callback=configured
// expect-only: dynamic_reconfigure_server
#include <base_driver/DriverConfig.h>
#include <boost/bind.hpp>
#include <dynamic_reconfigure/server.h>
#include <ros/ros.h>

class Driver
{
public:
  explicit Driver(ros::NodeHandle & handle) : server_(handle)
  {
    server_.setCallback(boost::bind(&Driver::configured, this, _1, _2));
  }

private:
  void configured(base_driver::DriverConfig & config, uint32_t)
  {
    rate_ = config.rate;
  }

  dynamic_reconfigure::Server<base_driver::DriverConfig> server_;
  double rate_;
};

int main(int argc, char ** argv)
{
  ros::init(argc, argv, "driver");
  ros::NodeHandle own("~"), arm("arm");
  Driver driver(own), second(arm);
  ros::spin();
}
