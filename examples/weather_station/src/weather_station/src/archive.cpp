#include <string>

#include <ros/ros.h>
#include <ros/service.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

namespace
{
bool onFlush(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response)
{
  response.success = true;
  return true;
}
}  // namespace

class Archive
{
public:
  Archive()
  {
    flush_ = nh_.advertiseService("flush", onFlush);
    enable_ = nh_.advertiseService("enable", &Archive::onEnable, this);
    lock_ = nh_.advertiseService("lock", &Archive::onLock, this);
    tag_ = nh_.advertiseService<std_srvs::SetBool::Request, std_srvs::SetBool::Response>("tag", boost::bind(&Archive::onTag, this, _1, _2, "v1"));
    ros::AdvertiseServiceOptions options =
        ros::AdvertiseServiceOptions::create<std_srvs::Trigger>("rotate", onFlush, ros::VoidConstPtr(), nullptr);
    rotate_ = nh_.advertiseService(options);

    upload_ = nh_.serviceClient<std_srvs::Trigger>("/cloud/upload", true);
    check_ = nh_.serviceClient<std_srvs::SetBool::Request, std_srvs::SetBool::Response>("check");
    sync_ = ros::service::createClient<std_srvs::Trigger>("sync");
  }

  void close()
  {
    std_srvs::Trigger last;
    if (ros::service::waitForService("/cloud/close", 1000))
    {
      ros::service::call("/cloud/close", last);
    }
    std_srvs::SetBool::Request request;
    std_srvs::SetBool::Response response;
    ros::service::call("power", request, response);
  }

private:
  bool onEnable(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response)
  {
    response.success = request.data;
    return true;
  }

  bool onLock(ros::ServiceEvent<std_srvs::SetBool::Request, std_srvs::SetBool::Response>& event)
  {
    event.getResponse().message = event.getCallerName();
    return true;
  }

  bool onTag(std_srvs::SetBool::Request&, std_srvs::SetBool::Response& response, const std::string& tag)
  {
    response.message = tag;
    return true;
  }

  ros::NodeHandle nh_{ "archive" };
  ros::ServiceServer flush_, enable_, lock_, tag_, rotate_;
  ros::ServiceClient upload_, check_, sync_;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "archive");
  Archive archive;
  ros::spin();
  archive.close();
  return 0;
}
