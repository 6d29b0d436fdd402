// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <rclcpp/rosarch_node.hpp>
namespace rclcpp {
enum class FutureReturnCode { SUCCESS, INTERRUPTED, TIMEOUT };
enum class SignalHandlerOptions { All, SigInt, SigTerm, None };
std::ostream& operator<<(std::ostream&, FutureReturnCode);
class InitOptions { public: InitOptions(); InitOptions& auto_initialize_logging(bool); bool shutdown_on_signal; void set_domain_id(size_t); };
struct ExecutorOptions { ExecutorOptions(); Context::SharedPtr context; size_t max_conditions; std::shared_ptr<rosarch::any> memory_strategy; };
class Executor {
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Executor)
  explicit Executor(const ExecutorOptions& = ExecutorOptions()); virtual ~Executor();
  template <class N> void add_node(const N& node, bool notify = true); template <class N> void remove_node(const N& node, bool notify = true);
  template <class... A> void add_callback_group(const A&...); template <class... A> void remove_callback_group(const A&...);
  virtual void spin(); virtual void cancel(); bool is_spinning();
  template <class T = std::chrono::nanoseconds> void spin_some(T = T(0)); template <class T> void spin_all(T); template <class T = std::chrono::nanoseconds> void spin_once(T = T(-1));
  template <class N> void spin_node_some(const N&); template <class N, class... A> void spin_node_once(const N&, const A&...);
  template <class F, class T = std::chrono::nanoseconds> FutureReturnCode spin_until_future_complete(const F& future, T = T(-1));
};
namespace executors {
using rclcpp::ExecutorOptions;
class SingleThreadedExecutor : public Executor { public: RCLCPP_SMART_PTR_DEFINITIONS(SingleThreadedExecutor) explicit SingleThreadedExecutor(const ExecutorOptions& = ExecutorOptions()); void spin() override; };
class MultiThreadedExecutor : public Executor { public: RCLCPP_SMART_PTR_DEFINITIONS(MultiThreadedExecutor)
  explicit MultiThreadedExecutor(const ExecutorOptions& = ExecutorOptions(), size_t number_of_threads = 0, bool yield_before_execute = false,
    std::chrono::nanoseconds timeout = std::chrono::nanoseconds(-1)); void spin() override; size_t get_number_of_threads(); };
class StaticSingleThreadedExecutor : public Executor { public: RCLCPP_SMART_PTR_DEFINITIONS(StaticSingleThreadedExecutor) explicit StaticSingleThreadedExecutor(const ExecutorOptions& = ExecutorOptions()); void spin() override; };
template <class N, class F, class... A> FutureReturnCode spin_node_until_future_complete(Executor&, const N&, const F&, const A&...);
}
namespace experimental { namespace executors { class EventsExecutor : public Executor { public: RCLCPP_SMART_PTR_DEFINITIONS(EventsExecutor) template <class... A> EventsExecutor(const A&...); void spin() override; }; } }
using rclcpp::executors::MultiThreadedExecutor;
using rclcpp::executors::SingleThreadedExecutor;
template <class... A> void init(int argc, const A&... argv_and_options);
std::vector<std::string> init_and_remove_ros_arguments(int argc, char const* const* argv, const InitOptions& = InitOptions());
std::vector<std::string> remove_ros_arguments(int argc, char const* const* argv);
bool ok(Context::SharedPtr context = nullptr);
bool shutdown(Context::SharedPtr context = nullptr, const std::string& reason = "");
bool signal_handlers_installed(); bool install_signal_handlers(SignalHandlerOptions = SignalHandlerOptions::All); bool uninstall_signal_handlers();
template <class F> void on_shutdown(const F& callback, Context::SharedPtr context = nullptr);
bool sleep_for(const std::chrono::nanoseconds&, Context::SharedPtr context = nullptr);
template <class N> void spin(const N& node);
template <class N> void spin_some(const N& node);
template <class N, class... A> void spin_all(const N& node, const A&...);
template <class N, class F, class... A> FutureReturnCode spin_until_future_complete(const N& node, const F& future, const A&... timeout);
namespace contexts { Context::SharedPtr get_global_default_context(); class DefaultContext : public Context { public: RCLCPP_SMART_PTR_DEFINITIONS(DefaultContext) }; }
}
