// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <sensor_msgs/CameraInfo.h>
#include <opencv2/core/core.hpp>
namespace image_geometry {
class PinholeCameraModel { public: PinholeCameraModel(); bool fromCameraInfo(const sensor_msgs::CameraInfo&);
  bool fromCameraInfo(const sensor_msgs::CameraInfoConstPtr&); std::string tfFrame() const; ros::Time stamp() const;
  cv::Size fullResolution() const; cv::Size reducedResolution() const; cv::Point2d project3dToPixel(const cv::Point3d&) const;
  cv::Point3d projectPixelTo3dRay(const cv::Point2d&) const; cv::Point2d rectifyPoint(const cv::Point2d&) const;
  cv::Point2d unrectifyPoint(const cv::Point2d&) const; void rectifyImage(const cv::Mat&, cv::Mat&, int = 0) const;
  const cv::Matx33d& intrinsicMatrix() const; const cv::Matx34d& projectionMatrix() const; const cv::Mat_<double>& distortionCoeffs() const;
  double fx() const; double fy() const; double cx() const; double cy() const; double Tx() const; double Ty() const;
  bool initialized() const; const sensor_msgs::CameraInfo& cameraInfo() const; double getDeltaX(double, double) const; };
class StereoCameraModel { public: template <class A> bool fromCameraInfo(const A&, const A&); const PinholeCameraModel& left() const;
  const PinholeCameraModel& right() const; double baseline() const; };
}
