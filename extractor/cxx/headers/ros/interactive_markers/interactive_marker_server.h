// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <ros/ros.h>
#include <visualization_msgs/InteractiveMarker.h>
#include <visualization_msgs/InteractiveMarkerFeedback.h>
namespace interactive_markers {
class InteractiveMarkerServer { public: typedef boost::function<void(const visualization_msgs::InteractiveMarkerFeedbackConstPtr&)>
  FeedbackCallback; static const uint8_t DEFAULT_FEEDBACK_CB = 255;
  InteractiveMarkerServer(const std::string& topic_ns, const std::string& server_id = "", bool spin_thread = false);
  void insert(const visualization_msgs::InteractiveMarker&);
  template <class F> void insert(const visualization_msgs::InteractiveMarker&, const F& callback, uint8_t = 255);
  template <class... A> bool setPose(const std::string&, const A&...); bool erase(const std::string&); void clear(); bool empty() const;
  std::size_t size() const; template <class F> bool setCallback(const std::string&, const F& callback, uint8_t = 255); void applyChanges();
  bool get(std::string, visualization_msgs::InteractiveMarker&) const; };
class MenuHandler { public: typedef uint32_t EntryHandle; enum CheckState { NO_CHECKBOX, CHECKED, UNCHECKED };
  template <class... A> EntryHandle insert(const A&...); bool setVisible(EntryHandle, bool); bool setCheckState(EntryHandle, CheckState);
  bool getCheckState(EntryHandle, CheckState&) const; bool apply(InteractiveMarkerServer&, const std::string&);
  bool reApply(InteractiveMarkerServer&); };
}
