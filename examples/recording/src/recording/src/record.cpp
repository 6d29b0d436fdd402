#include <ros/ros.h>
#include <rosbag/recorder.h>

int main(int argc, char** argv)
{
  ros::init(argc, argv, "record");
  rosbag::RecorderOptions options;
  options.record_all = true;
  rosbag::Recorder recorder(options);
  return recorder.run();
}
