// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <tf/transform_datatypes.h>
#include <tf/exceptions.h>
#include <tf/time_cache.h>
#include <tf/tfMessage.h>
#include <ros/time.h>
#include <ros/console.h>
#include <ros/node_handle.h>
#include <set>
namespace tf {
std::string resolve(const std::string& prefix, const std::string& frame);
std::string strip_leading_slash(const std::string&);
std::string getPrefixParam(ros::NodeHandle&);
enum ErrorValues { NO_ERROR = 0, LOOKUP_ERROR, CONNECTIVITY_ERROR, EXTRAPOLATION_ERROR };
// Frames, times and results are not checked: (target, source, time, out), (target, target time, source, source time, fixed, out), ...
class Transformer {
public:
  static const unsigned int MAX_GRAPH_DEPTH = 100;
  static const double DEFAULT_CACHE_TIME;
  Transformer(bool interpolating = true, ros::Duration cache_time = ros::Duration());
  virtual ~Transformer();
  void clear();
  bool setTransform(const StampedTransform&, const std::string& = "");
  template <class A, class B, class... X> void lookupTransform(const A& target, const B& source, X&&...) const;
  template <class... A> void lookupTwist(A&&...) const;
  template <class A, class B, class... X> bool waitForTransform(const A& target, const B& source, X&&...) const;
  template <class A, class B, class... X> bool canTransform(const A& target, const B& source, X&&...) const;
  template <class A, class B> int getLatestCommonTime(const A&, const B&, ros::Time&, std::string*) const;
  template <class A, class... X> void transformQuaternion(const A& target, X&&...) const;
  template <class A, class... X> void transformVector(const A& target, X&&...) const;
  template <class A, class... X> void transformPoint(const A& target, X&&...) const;
  template <class A, class... X> void transformPose(const A& target, X&&...) const;
  template <class A, class... X> void transformPointCloud(const A& target, X&&...) const;
  bool frameExists(const std::string&) const;
  bool getParent(const std::string&, ros::Time, std::string&) const;
  void getFrameStrings(std::vector<std::string>&) const;
  std::string allFramesAsString() const;
  std::string allFramesAsDot(double = 0) const;
  std::string chainAsString(const std::string&, ros::Time, const std::string&, ros::Time, const std::string&) const;
  void setExtrapolationLimit(const ros::Duration&);
  ros::Duration getCacheLength();
  std::string getTFPrefix() const;
  bool isUsingDedicatedThread();
  void setUsingDedicatedThread(bool);
};
}
