// A service answers what a topic told; a client sends on what it is answered, and asks for what it was told.
//
// expect: port_flow([_, _, "/battery"], [_, "service_server", "/charge"], "data", "kept")
// expect: port_flow([_, "service_client", "/weather"], [_, _, "/forecast"], "data", "reactive")
// expect: port_flow([_, _, "/place"], [_, "service_client", "/weather"], "data", "reactive")
// expect-not: port_flow([_, _, "/battery"], [_, _, "/forecast"], _, _)
// expect-not: port_flow([_, _, "/place"], [_, "service_server", _], _, _)
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_msgs/String.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

class Station
{
public:
  Station()
  {
    battery_ = nh_.subscribe("/battery", 1, &Station::onBattery, this);
    place_ = nh_.subscribe("/place", 1, &Station::onPlace, this);
    server_ = nh_.advertiseService("/charge", &Station::onCharge, this);
    client_ = nh_.serviceClient<std_srvs::SetBool>("/weather");
    pub_ = nh_.advertise<std_msgs::String>("/forecast", 1);
  }

private:
  void onBattery(const std_msgs::String& battery) { charge_ = battery.data; }
  bool onCharge(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response)
  {
    response.message = charge_;
    return true;
  }
  void onPlace(const std_msgs::Bool& place)
  {
    std_srvs::SetBool weather;
    weather.request.data = place.data;
    client_.call(weather);
    std_msgs::String forecast;
    forecast.data = weather.response.message;
    pub_.publish(forecast);
  }

  ros::NodeHandle nh_;
  ros::Subscriber battery_, place_;
  ros::ServiceServer server_;
  ros::ServiceClient client_;
  ros::Publisher pub_;
  std::string charge_;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "station");
  Station station;
  ros::spin();
}
