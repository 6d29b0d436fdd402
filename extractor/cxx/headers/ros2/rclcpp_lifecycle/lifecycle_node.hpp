// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <rclcpp/rclcpp.hpp>
#include <lifecycle_msgs/msg/state.hpp>
#include <lifecycle_msgs/msg/transition.hpp>
namespace rclcpp_lifecycle {
class State { public: State(); State(const State&); template <class... A> State(uint8_t id, const A&...); State& operator=(const State&); uint8_t id() const; std::string label() const; void reset() noexcept; };
class Transition { public: template <class... A> Transition(const A&...); uint8_t id() const; std::string label() const; State start_state() const; State goal_state() const; };
class ManagedEntityInterface { public: virtual ~ManagedEntityInterface(); virtual void on_activate() = 0; virtual void on_deactivate() = 0; };
class SimpleManagedEntity : public ManagedEntityInterface { public: ~SimpleManagedEntity() override; void on_activate() override; void on_deactivate() override; bool is_activated() const; };
class LifecyclePublisherInterface : public SimpleManagedEntity {};
template <class M, class Alloc = std::allocator<void>> class LifecyclePublisher : public SimpleManagedEntity, public rclcpp::Publisher<M> { public: RCLCPP_SMART_PTR_DEFINITIONS(LifecyclePublisher)
  template <class... A> LifecyclePublisher(const A&...); template <class X> void publish(X&& message); bool is_activated() const; void on_activate() override; void on_deactivate() override; };
namespace node_interfaces {
class LifecycleNodeInterface { public:
  enum class CallbackReturn : uint8_t { SUCCESS = 97, FAILURE = 98, ERROR = 99 };
  virtual CallbackReturn on_configure(const State& previous_state); virtual CallbackReturn on_cleanup(const State& previous_state); virtual CallbackReturn on_shutdown(const State& previous_state);
  virtual CallbackReturn on_activate(const State& previous_state); virtual CallbackReturn on_deactivate(const State& previous_state); virtual CallbackReturn on_error(const State& previous_state);
  virtual ~LifecycleNodeInterface(); };
}
class LifecycleNode : public node_interfaces::LifecycleNodeInterface, public std::enable_shared_from_this<LifecycleNode> {
  typedef rclcpp::Event Event; template <class M> using Subscription = rclcpp::Subscription<M>; template <class S> using Service = rclcpp::Service<S>; template <class S> using Client = rclcpp::Client<S>;
  typedef rclcpp::TimerBase TimerBase; typedef rclcpp::QoS QoS; typedef rclcpp::PublisherOptions PublisherOptions; typedef rclcpp::SubscriptionOptions SubscriptionOptions;
  typedef rclcpp::GenericPublisher GenericPublisher; typedef rclcpp::GenericSubscription GenericSubscription; typedef rclcpp::ParameterValue ParameterValue; typedef rclcpp::NodeOptions NodeOptions;
  typedef rclcpp::Logger Logger; typedef rclcpp::CallbackGroup CallbackGroup; typedef rclcpp::CallbackGroupType CallbackGroupType; typedef rclcpp::Clock Clock; typedef rclcpp::Time Time; typedef rclcpp::ClientBase ClientBase;
public:
  RCLCPP_SMART_PTR_DEFINITIONS(LifecycleNode)
  using rclcpp_lifecycle::node_interfaces::LifecycleNodeInterface::CallbackReturn;
  explicit LifecycleNode(const std::string& node_name, const rclcpp::NodeOptions& options = rclcpp::NodeOptions(), bool enable_communication_interface = true);
  LifecycleNode(const std::string& node_name, const std::string& namespace_, const rclcpp::NodeOptions& options = rclcpp::NodeOptions(), bool enable_communication_interface = true);
  virtual ~LifecycleNode();
  const State& get_current_state() const; std::vector<State> get_available_states() const; std::vector<Transition> get_available_transitions() const; std::vector<Transition> get_transition_graph() const;
  template <class... A> const State& trigger_transition(A&&...); template <class... A> const State& configure(A&&...); template <class... A> const State& cleanup(A&&...);
  template <class... A> const State& activate(A&&...); template <class... A> const State& deactivate(A&&...); template <class... A> const State& shutdown(A&&...);
  template <class F> bool register_on_configure(F f); template <class F> bool register_on_cleanup(F f); template <class F> bool register_on_shutdown(F f); template <class F> bool register_on_activate(F f);
  template <class F> bool register_on_deactivate(F f); template <class F> bool register_on_error(F f); void add_managed_entity(std::weak_ptr<ManagedEntityInterface>);
  ROSARCH_PORT_METHODS(LifecyclePublisher)
  ROSARCH_PARAMETER_TYPES
  ROSARCH_PARAMETER_METHODS
  ROSARCH_GRAPH_METHODS
  ROSARCH_INTERFACE_METHODS
};
}
namespace rclcpp { template <class M, class T, class Q, class... A> std::shared_ptr<rclcpp_lifecycle::LifecyclePublisher<M>> create_publisher(rclcpp_lifecycle::LifecycleNode& node, const T& topic, const Q& qos, const A&... options); }
