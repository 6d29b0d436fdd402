// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <ros/ros.h>
#include <diagnostic_msgs/DiagnosticArray.h>
#include <diagnostic_msgs/DiagnosticStatus.h>
namespace diagnostic_updater {
class DiagnosticStatusWrapper : public diagnostic_msgs::DiagnosticStatus { public: void summary(unsigned char, const std::string&);
  void summary(const diagnostic_msgs::DiagnosticStatus&); void summaryf(unsigned char, const char*, ...);
  void mergeSummary(unsigned char, const std::string&); void mergeSummary(const diagnostic_msgs::DiagnosticStatus&);
  void mergeSummaryf(unsigned char, const char*, ...); void clearSummary(); void addf(const std::string&, const char*, ...);
  template <class T> void add(const std::string& key, const T& value); void clear(); };
typedef boost::function<void(DiagnosticStatusWrapper&)> TaskFunction;
class DiagnosticTask { public: DiagnosticTask(const std::string&); const std::string& getName();
  virtual void run(DiagnosticStatusWrapper&) = 0; virtual ~DiagnosticTask(); };
template <class T> class GenericFunctionDiagnosticTask : public DiagnosticTask { public: template <class F>
  GenericFunctionDiagnosticTask(const std::string&, const F&); void run(DiagnosticStatusWrapper&) override; };
typedef GenericFunctionDiagnosticTask<DiagnosticStatusWrapper> FunctionDiagnosticTask;
class CompositeDiagnosticTask : public DiagnosticTask { public: CompositeDiagnosticTask(const std::string&);
  void run(DiagnosticStatusWrapper&) override; void addTask(DiagnosticTask*); };
class DiagnosticTaskVector { public: virtual ~DiagnosticTaskVector(); template <class... A> void add(const std::string& name, const A&...);
  void add(DiagnosticTask&); bool removeByName(const std::string&); };
class Updater : public DiagnosticTaskVector { public: bool verbose_;
  Updater(ros::NodeHandle = ros::NodeHandle(), ros::NodeHandle = ros::NodeHandle("~"), const std::string& = std::string()); void update();
  void force_update(); double getPeriod(); void broadcast(int, const std::string&); void setHardwareID(const std::string&);
  void setHardwareIDf(const char*, ...); };
struct FrequencyStatusParam { FrequencyStatusParam(double*, double*, double = 0.1, int = 5); double* min_freq_; double* max_freq_;
  double tolerance_; int window_size_; };
class FrequencyStatus : public DiagnosticTask { public: FrequencyStatus(const FrequencyStatusParam&);
  FrequencyStatus(const FrequencyStatusParam&, const std::string&); void clear(); void tick(); void run(DiagnosticStatusWrapper&) override;
  };
struct TimeStampStatusParam { TimeStampStatusParam(double = -1, double = 5); double max_acceptable_; double min_acceptable_; };
class TimeStampStatus : public DiagnosticTask { public: TimeStampStatus(); TimeStampStatus(const TimeStampStatusParam&);
  TimeStampStatus(const TimeStampStatusParam&, const std::string&); void tick(double); void tick(const ros::Time&);
  void run(DiagnosticStatusWrapper&) override; };
class Heartbeat : public DiagnosticTask { public: Heartbeat(); void run(DiagnosticStatusWrapper&) override; };
class HeaderlessTopicDiagnostic : public CompositeDiagnosticTask { public: HeaderlessTopicDiagnostic(const std::string&, Updater&,
  const FrequencyStatusParam&); virtual void tick(); void clear_window(); };
class TopicDiagnostic : public HeaderlessTopicDiagnostic { public: TopicDiagnostic(const std::string&, Updater&,
  const FrequencyStatusParam&, const TimeStampStatusParam&); void tick() override; virtual void tick(const ros::Time&); };
template <class T> class DiagnosedPublisher : public TopicDiagnostic { public: DiagnosedPublisher(const ros::Publisher&, Updater&,
  const FrequencyStatusParam&, const TimeStampStatusParam&); template <class M> void publish(const M& message);
  ros::Publisher getPublisher() const; void setPublisher(ros::Publisher); };
}
