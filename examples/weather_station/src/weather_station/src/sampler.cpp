#include <functional>
#include <string>
#include <vector>

#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <ros/spinner.h>
#include <ros/topic.h>
#include <sensor_msgs/RelativeHumidity.h>
#include <sensor_msgs/Temperature.h>
#include <std_msgs/Float64.h>
#include <std_msgs/String.h>

namespace
{
struct LogStatus
{
  void operator()(const std_msgs::String::ConstPtr& message) const
  {
    ROS_INFO("%s", message->data.c_str());
  }
};

void onPressure(const std_msgs::Float64& pressure)
{
  ROS_DEBUG("pressure %f", pressure.data);
}

void onWind(const ros::MessageEvent<std_msgs::Float64 const>& event)
{
  ROS_DEBUG("wind from %s", event.getPublisherName().c_str());
}
}  // namespace

class Sampler
{
public:
  Sampler() : private_nh_("~")
  {
    subscribeAll();
    advertiseAll();
    sensor_msgs::TemperatureConstPtr first = ros::topic::waitForMessage<sensor_msgs::Temperature>("outside", ros::Duration(10));
    offset_ = first ? first->temperature : 0.0;
    std_msgs::StringConstPtr site = ros::topic::waitForMessage<std_msgs::String>("site", private_nh_);
    site_ = site ? site->data : "";
  }

  static void onReset(const std_msgs::StringConstPtr&)
  {
  }

private:
  void subscribeAll()
  {
    subscribers_.push_back(nh_.subscribe("temperature", 1, &Sampler::onTemperature, this));
    subscribers_.push_back(nh_.subscribe("humidity", 2, &Sampler::onHumidity, this, ros::TransportHints().tcpNoDelay()));
    subscribers_.push_back(nh_.subscribe("reset", 3, Sampler::onReset));
    subscribers_.push_back(nh_.subscribe("pressure", 4, onPressure));
    subscribers_.push_back(nh_.subscribe("wind", 5, &onWind));
    subscribers_.push_back(nh_.subscribe<std_msgs::String>("status", 6, LogStatus()));
    subscribers_.push_back(nh_.subscribe<std_msgs::Float64>("rain", 7, [this](const std_msgs::Float64ConstPtr& rain) { offset_ += rain->data; }));
    subscribers_.push_back(nh_.subscribe<std_msgs::Float64>("probe_2", 8, boost::bind(&Sampler::onProbe, this, _1, 2)));
    const std::function<void(const std_msgs::Float64ConstPtr&)> third = std::bind(&Sampler::onProbe, this, std::placeholders::_1, 3);
    subscribers_.push_back(nh_.subscribe<std_msgs::Float64>("probe_3", 9, third));

    ros::SubscribeOptions slow = ros::SubscribeOptions::create<std_msgs::Float64>("slow", 10, boost::bind(&Sampler::onProbe, this, _1, 4),
                                                                                 ros::VoidPtr(), &queue_);
    subscribers_.push_back(private_nh_.subscribe(slow));
  }

  void advertiseAll()
  {
    mean_ = nh_.advertise<std_msgs::Float64>("mean", 1);
    station_ = private_nh_.advertise<std_msgs::String>("station", 1, true);
    history_ = nh_.advertise<std_msgs::Float64>("history", 20, boost::bind(&Sampler::onListener, this, _1), ros::SubscriberStatusCallback(),
                                                ros::VoidConstPtr(), true);
    ros::AdvertiseOptions options;
    options.init<std_msgs::Float64>("extremes", 5);
    options.latch = true;
    extremes_ = nh_.advertise(options);
  }

  void onTemperature(const sensor_msgs::TemperatureConstPtr& message)
  {
    std_msgs::Float64 mean;
    mean.data = 0.5 * (offset_ + message->temperature);
    mean_.publish(mean);
  }

  void onHumidity(const sensor_msgs::RelativeHumidity& message)
  {
    offset_ = message.relative_humidity;
  }

  void onProbe(const std_msgs::Float64ConstPtr& message, int probe)
  {
    ROS_INFO("probe %d: %f", probe, message->data);
  }

  void onListener(const ros::SingleSubscriberPublisher& listener)
  {
    ROS_INFO("%s listens", listener.getSubscriberName().c_str());
  }

  ros::NodeHandle nh_, private_nh_;
  ros::CallbackQueue queue_;
  std::vector<ros::Subscriber> subscribers_;
  ros::Publisher mean_, station_, history_, extremes_;
  double offset_ = 0.0;
  std::string site_;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "sampler");
  Sampler sampler;
  ros::MultiThreadedSpinner spinner(2);
  spinner.spin();
  return 0;
}
