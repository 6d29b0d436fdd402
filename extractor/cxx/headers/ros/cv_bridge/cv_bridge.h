// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <sensor_msgs/Image.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/image_encodings.h>
#include <opencv2/core/core.hpp>
#include <stdexcept>
namespace cv_bridge {
class Exception : public std::runtime_error { public: Exception(const std::string&); };
class CvImage;
typedef boost::shared_ptr<CvImage> CvImagePtr;
typedef boost::shared_ptr<const CvImage> CvImageConstPtr;
class CvImage {
public:
  std_msgs::Header header; std::string encoding; cv::Mat image;
  typedef boost::shared_ptr<CvImage> Ptr; typedef boost::shared_ptr<const CvImage> ConstPtr;
  CvImage(); CvImage(const std_msgs::Header&, const std::string&, const cv::Mat& = cv::Mat());
  sensor_msgs::ImagePtr toImageMsg() const; void toImageMsg(sensor_msgs::Image&) const;
    sensor_msgs::CompressedImagePtr toCompressedImageMsg(int = 0) const;
    void toCompressedImageMsg(sensor_msgs::CompressedImage&, int = 0) const;
};
struct CvtColorForDisplayOptions { bool do_dynamic_scaling; double min_image_value; double max_image_value; int colormap; int bg_label; };
template <class M> CvImagePtr toCvCopy(const M& source, const std::string& encoding = std::string());
template <class M, class... A> CvImageConstPtr toCvShare(const M& source, const A&...);
CvImagePtr cvtColor(const CvImageConstPtr&, const std::string&);
  template <class... A> CvImageConstPtr cvtColorForDisplay(const CvImageConstPtr&, const A&...); int getCvType(const std::string&);
}
