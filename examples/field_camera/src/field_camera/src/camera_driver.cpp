#include <boost/make_shared.hpp>
#include <camera_info_manager/camera_info_manager.h>
#include <diagnostic_updater/diagnostic_updater.h>
#include <diagnostic_updater/publisher.h>
#include <dynamic_reconfigure/server.h>
#include <field_camera/CameraConfig.h>
#include <image_transport/image_transport.h>
#include <ros/ros.h>

class CameraDriver
{
public:
  CameraDriver()
    : private_nh_("~")
    , transport_(nh_)
    , info_(ros::NodeHandle("camera"), "field_camera")
    , min_rate_(9.0)
    , max_rate_(11.0)
    , rate_(diagnostic_updater::FrequencyStatusParam(&min_rate_, &max_rate_))
  {
    camera_ = transport_.advertiseCamera("camera/image_raw", 2);
    preview_ = image_transport::ImageTransport(private_nh_).advertise("preview", 1, true);
    updater_.setHardwareID("field camera");
    updater_.add("exposure", this, &CameraDriver::reportExposure);
    updater_.add(rate_);
    reconfigure_ = boost::make_shared<Reconfigure>(private_nh_);
    reconfigure_->setCallback(boost::bind(&CameraDriver::onConfig, this, _1, _2));
  }

  void grab()
  {
    sensor_msgs::ImagePtr image = boost::make_shared<sensor_msgs::Image>();
    sensor_msgs::CameraInfoPtr info = boost::make_shared<sensor_msgs::CameraInfo>(info_.getCameraInfo());
    camera_.publish(image, info);
    preview_.publish(image);
    rate_.tick();
    updater_.update();
  }

private:
  typedef dynamic_reconfigure::Server<field_camera::CameraConfig> Reconfigure;

  void reportExposure(diagnostic_updater::DiagnosticStatusWrapper& status)
  {
    status.add("exposure", exposure_);
  }

  void onConfig(field_camera::CameraConfig& config, uint32_t)
  {
    exposure_ = config.exposure;
  }

  ros::NodeHandle nh_, private_nh_;
  image_transport::ImageTransport transport_;
  image_transport::CameraPublisher camera_;
  image_transport::Publisher preview_;
  camera_info_manager::CameraInfoManager info_;
  diagnostic_updater::Updater updater_;
  double min_rate_, max_rate_;
  diagnostic_updater::FrequencyStatus rate_;
  boost::shared_ptr<Reconfigure> reconfigure_;
  double exposure_ = 0.01;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "camera_driver");
  CameraDriver driver;
  ros::Rate rate(10);
  while (ros::ok())
  {
    driver.grab();
    ros::spinOnce();
    rate.sleep();
  }
  return 0;
}
