// Publishers whose rate is diagnosed send through those that they are made of.
//
// expect: publisher scan sensor_msgs/LaserScan
// expect: publisher cloud sensor_msgs/PointCloud2
// expect: reactive start -> scan must
// expect: reactive start -> cloud must
#include <diagnostic_updater/diagnostic_updater.h>
#include <diagnostic_updater/publisher.h>
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_msgs/Empty.h>

class Driver
{
public:
  Driver()
    : scan_(nh_.advertise<sensor_msgs::LaserScan>("scan", 1), updater_, diagnostic_updater::FrequencyStatusParam(&hz_, &hz_),
            diagnostic_updater::TimeStampStatusParam())
  {
    ros::Publisher cloud = nh_.advertise<sensor_msgs::PointCloud2>("cloud", 1);
    cloud_ = new diagnostic_updater::DiagnosedPublisher<sensor_msgs::PointCloud2>(
        cloud, updater_, diagnostic_updater::FrequencyStatusParam(&hz_, &hz_), diagnostic_updater::TimeStampStatusParam());
    sub_ = nh_.subscribe("start", 1, &Driver::onStart, this);
  }

private:
  void onStart(const std_msgs::Empty::ConstPtr&)
  {
    scan_.publish(sensor_msgs::LaserScan());
    cloud_->publish(sensor_msgs::PointCloud2());
  }

  ros::NodeHandle nh_;
  double hz_ = 10.0;
  diagnostic_updater::Updater updater_;
  diagnostic_updater::DiagnosedPublisher<sensor_msgs::LaserScan> scan_;
  diagnostic_updater::DiagnosedPublisher<sensor_msgs::PointCloud2>* cloud_;
  ros::Subscriber sub_;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "driver");
  Driver driver;
  ros::spin();
}
