// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <rclcpp/rclcpp.hpp>
#include <diagnostic_msgs/msg/diagnostic_array.hpp>
#include <diagnostic_msgs/msg/diagnostic_status.hpp>
namespace diagnostic_updater {
class DiagnosticStatusWrapper : public diagnostic_msgs::msg::DiagnosticStatus { public: void summary(unsigned char, const std::string&); void summary(const diagnostic_msgs::msg::DiagnosticStatus&);
  template <class... A> void summaryf(unsigned char, const A&...); void mergeSummary(unsigned char, const std::string&); void mergeSummary(const diagnostic_msgs::msg::DiagnosticStatus&);
  template <class... A> void mergeSummaryf(unsigned char, const A&...); void clearSummary(); template <class... A> void addf(const std::string&, const A&...); template <class T> void add(const std::string& key, const T& value); void clear(); };
typedef std::function<void(DiagnosticStatusWrapper&)> TaskFunction;
class DiagnosticTask { public: DiagnosticTask(const std::string); const std::string& getName(); virtual void run(DiagnosticStatusWrapper&) = 0; virtual ~DiagnosticTask(); };
template <class T> class GenericFunctionDiagnosticTask : public DiagnosticTask { public: template <class F> GenericFunctionDiagnosticTask(const std::string&, const F&); void run(DiagnosticStatusWrapper&) override; };
typedef GenericFunctionDiagnosticTask<DiagnosticStatusWrapper> FunctionDiagnosticTask;
class CompositeDiagnosticTask : public DiagnosticTask { public: CompositeDiagnosticTask(const std::string); void run(DiagnosticStatusWrapper&) override; void addTask(DiagnosticTask*); };
class DiagnosticTaskVector { public: virtual ~DiagnosticTaskVector(); template <class... A> void add(const std::string& name, const A&... function); void add(DiagnosticTask&); bool removeByName(const std::string); };
class Updater : public DiagnosticTaskVector { public: bool verbose_; template <class N, class... A> explicit Updater(N&& node, const A&... period); double getPeriod() const; template <class T> void setPeriod(const T&);
  void update(); void force_update(); void broadcast(unsigned char, const std::string); template <class... A> void setHardwareIDf(const A&...); void setHardwareID(const std::string&); };
struct FrequencyStatusParam { FrequencyStatusParam(double*, double*, double = 0.1, size_t = 5); double* min_freq_; double* max_freq_; double tolerance_; size_t window_size_; };
class FrequencyStatus : public DiagnosticTask { public: template <class... A> FrequencyStatus(const FrequencyStatusParam&, const A&...); void clear(); void tick(); void run(DiagnosticStatusWrapper&) override; };
struct TimeStampStatusParam { TimeStampStatusParam(double = -1, double = 5); double max_acceptable_, min_acceptable_; };
class TimeStampStatus : public DiagnosticTask { public: template <class... A> TimeStampStatus(const A&...); template <class T> void tick(const T&); void run(DiagnosticStatusWrapper&) override; };
class Heartbeat : public DiagnosticTask { public: Heartbeat(); void run(DiagnosticStatusWrapper&) override; };
class HeaderlessTopicDiagnostic : public CompositeDiagnosticTask { public: template <class... A> HeaderlessTopicDiagnostic(const std::string, Updater&, const A&...); virtual void tick(); void clear_window(); };
class TopicDiagnostic : public HeaderlessTopicDiagnostic { public: template <class... A> TopicDiagnostic(const std::string, Updater&, const A&...); void tick() override; template <class T> void tick(const T&); };
template <class P> class DiagnosedPublisher : public TopicDiagnostic { public: template <class X, class... A> DiagnosedPublisher(const X&, Updater&, const A&...); template <class M> void publish(M&& message); };
}
