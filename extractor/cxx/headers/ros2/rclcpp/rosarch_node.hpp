// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <atomic>
#include <array>
#include <future>
#include <variant>
#include <rclcpp/rosarch_parameters.hpp>
// Names, results and order of arguments are the real ones. Parameter types are free: no argument is converted, no two arguments have
// to agree, and an argument of unknown type does not lose the call.
namespace rclcpp {
enum class CallbackGroupType { MutuallyExclusive, Reentrant };
class CallbackGroup { public: RCLCPP_SMART_PTR_DEFINITIONS(CallbackGroup) std::atomic_bool& can_be_taken_from(); CallbackGroupType type() const; };
enum class TopicStatisticsState { Enable, Disable, NodeDefault };
enum class IntraProcessSetting { Enable, Disable, NodeDefault };
enum class IntraProcessBufferType { SharedPtr, UniquePtr, CallbackDefault };
template <class Alloc = std::allocator<void>> struct PublisherOptionsWithAllocator {
  PublisherOptionsWithAllocator(); template <class... X> PublisherOptionsWithAllocator(const X&...);
  PublisherEventCallbacks event_callbacks; CallbackGroup::SharedPtr callback_group; bool use_default_callbacks; IntraProcessSetting use_intra_process_comm;
  QosOverridingOptions qos_overriding_options; std::shared_ptr<Alloc> allocator; int require_unique_network_flow_endpoints; IntraProcessBufferType intra_process_buffer_type;
};
typedef PublisherOptionsWithAllocator<> PublisherOptions;
typedef PublisherOptions PublisherOptionsBase;
struct TopicStatisticsOptions { TopicStatisticsState state; std::string publish_topic; std::chrono::milliseconds publish_period; };
struct ContentFilterOptions { std::string filter_expression; std::vector<std::string> expression_parameters; };
template <class Alloc = std::allocator<void>> struct SubscriptionOptionsWithAllocator {
  SubscriptionOptionsWithAllocator(); template <class... X> SubscriptionOptionsWithAllocator(const X&...);
  SubscriptionEventCallbacks event_callbacks; CallbackGroup::SharedPtr callback_group; bool use_default_callbacks; bool ignore_local_publications;
  IntraProcessSetting use_intra_process_comm; QosOverridingOptions qos_overriding_options; TopicStatisticsOptions topic_stats_options;
  ContentFilterOptions content_filter_options; std::shared_ptr<Alloc> allocator; int require_unique_network_flow_endpoints; IntraProcessBufferType intra_process_buffer_type;
};
typedef SubscriptionOptionsWithAllocator<> SubscriptionOptions;
typedef SubscriptionOptions SubscriptionOptionsBase;
struct MessageInfo { MessageInfo(); MessageInfo(const rmw_message_info_t&); rmw_message_info_t& get_rmw_message_info(); const rmw_message_info_t& get_rmw_message_info() const; };
class SerializedMessage { public: RCLCPP_SMART_PTR_DEFINITIONS(SerializedMessage) SerializedMessage(); explicit SerializedMessage(size_t); size_t size() const;
  size_t capacity() const; void reserve(size_t); rosarch::any& get_rcl_serialized_message() const; };
template <class M> class Serialization { public: void serialize_message(const void*, SerializedMessage*) const; void deserialize_message(const SerializedMessage*, void*) const; };
template <class T, class M = void> struct TypeAdapter { template <class Custom> struct as { template <class Ros> using ros_message = TypeAdapter<Custom, Ros>; };
  typedef T custom_type; typedef M ros_message_type; };
template <class T> struct ImplicitTypeAdapter {};
template <class Custom> struct adapt_type { template <class Ros> using as = TypeAdapter<Custom, Ros>; };
#define RCLCPP_USING_CUSTOM_TYPE_AS_ROS_MESSAGE_TYPE(CUSTOM, ROS) \
  template <> struct rclcpp::ImplicitTypeAdapter<CUSTOM> : public rclcpp::TypeAdapter<CUSTOM, ROS> {};
template <class M> class LoanedMessage { public: M& get() const; bool is_valid() const; };
struct NetworkFlowEndpoint {};
class PublisherBase { public: RCLCPP_SMART_PTR_DEFINITIONS(PublisherBase) virtual ~PublisherBase(); const char* get_topic_name() const; size_t get_queue_size() const;
  size_t get_subscription_count() const; size_t get_intra_process_subscription_count() const; bool assert_liveliness() const; QoS get_actual_qos() const;
  bool can_loan_messages() const; bool is_durability_transient_local() const; template <class... A> bool wait_for_all_acked(const A&...) const;
  std::vector<NetworkFlowEndpoint> get_network_flow_endpoints() const; const std::array<uint8_t, 16>& get_gid() const; };
template <class M, class Alloc = std::allocator<void>> class Publisher : public PublisherBase { public: RCLCPP_SMART_PTR_DEFINITIONS(Publisher)
  typedef M ROSMessageType; typedef M PublishedType;
  template <class... A> Publisher(const A&...);
  template <class X> void publish(X&& message); LoanedMessage<M> borrow_loaned_message(); };
class GenericPublisher : public PublisherBase { public: RCLCPP_SMART_PTR_DEFINITIONS(GenericPublisher) template <class X> void publish(X&&); template <class X> void publish_as_loaned_msg(X&&); };
class SubscriptionBase { public: RCLCPP_SMART_PTR_DEFINITIONS(SubscriptionBase) virtual ~SubscriptionBase(); const char* get_topic_name() const; QoS get_actual_qos() const;
  size_t get_publisher_count() const; bool is_serialized() const; bool take_serialized(SerializedMessage&, MessageInfo&); bool take_type_erased(void*, MessageInfo&);
  std::shared_ptr<void> create_message(); template <class F> void set_on_new_message_callback(F); void clear_on_new_message_callback();
  bool is_cft_enabled() const; template <class... A> void set_content_filter(const A&...); ContentFilterOptions get_content_filter() const;
  std::vector<NetworkFlowEndpoint> get_network_flow_endpoints() const; std::shared_ptr<void> get_intra_process_waitable() const; };
template <class M, class Alloc = std::allocator<void>> class Subscription : public SubscriptionBase { public: RCLCPP_SMART_PTR_DEFINITIONS(Subscription)
  template <class... A> Subscription(const A&...);
  template <class X> bool take(X&& message, MessageInfo& info); };
class GenericSubscription : public SubscriptionBase { public: RCLCPP_SMART_PTR_DEFINITIONS(GenericSubscription) };
class ServiceBase { public: RCLCPP_SMART_PTR_DEFINITIONS(ServiceBase) virtual ~ServiceBase(); const char* get_service_name();
  template <class... A> void configure_introspection(const A&...); QoS get_response_publisher_actual_qos() const; };
template <class S> class Service : public ServiceBase { public: RCLCPP_SMART_PTR_DEFINITIONS(Service) template <class... A> void send_response(A&&...); };
struct FutureAndRequestIdBase { int64_t request_id; };
namespace detail { template <class F> struct FutureAndRequestId : public FutureAndRequestIdBase { FutureAndRequestId(); FutureAndRequestId(F, int64_t); F future; int64_t request_id; operator F&(); auto get() { return future.get(); } bool valid() const;
  auto share() { return future.share(); } void wait() const; template <class T> std::future_status wait_for(const T& t) const; template <class T> std::future_status wait_until(const T&) const; }; }
using detail::FutureAndRequestId;
class ClientBase { public: RCLCPP_SMART_PTR_DEFINITIONS(ClientBase) virtual ~ClientBase(); const char* get_service_name() const; bool service_is_ready() const;
  template <class T = std::chrono::nanoseconds> bool wait_for_service(T timeout = T(-1)); template <class... A> void configure_introspection(const A&...); };
template <class S> class Client : public ClientBase {
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Client)
  typedef typename S::Request Request; typedef typename S::Response Response;
  typedef std::shared_ptr<Request> SharedRequest; typedef std::shared_ptr<Response> SharedResponse;
  typedef std::promise<SharedResponse> Promise; typedef std::shared_ptr<Promise> SharedPromise; typedef std::future<SharedResponse> Future;
  typedef std::shared_future<SharedResponse> SharedFuture; typedef std::shared_future<std::pair<SharedRequest, SharedResponse>> SharedFutureWithRequest;
  typedef std::function<void(SharedFuture)> CallbackType; typedef std::function<void(SharedFutureWithRequest)> CallbackWithRequestType;
  struct FutureAndRequestId : public detail::FutureAndRequestId<Future> {}; struct SharedFutureAndRequestId : public detail::FutureAndRequestId<SharedFuture> {};
  template <class R> FutureAndRequestId async_send_request(R&& request);
  template <class R, class F> SharedFutureAndRequestId async_send_request(R&& request, F&& callback);
  template <class X> bool remove_pending_request(const X&); size_t prune_pending_requests(); template <class... A> size_t prune_requests_older_than(const A&...);
};
class TimerBase { public: RCLCPP_SMART_PTR_DEFINITIONS(TimerBase) virtual ~TimerBase(); void cancel(); bool is_canceled(); void reset(); bool is_ready(); bool is_steady();
  std::chrono::nanoseconds time_until_trigger(); std::shared_ptr<rosarch::any> get_timer_handle(); virtual void execute_callback(const std::shared_ptr<void>& = {}); bool call(); };
template <class F> class GenericTimer : public TimerBase { public: RCLCPP_SMART_PTR_DEFINITIONS(GenericTimer) template <class... A> GenericTimer(const A&...); };
template <class F> class WallTimer : public GenericTimer<F> { public: RCLCPP_SMART_PTR_DEFINITIONS(WallTimer) template <class... A> WallTimer(const A&...); };
struct TimerInfo { Time expected_call_time, actual_call_time; };
class Event { public: RCLCPP_SMART_PTR_DEFINITIONS(Event) bool check(); bool set(); };
class Waitable { public: RCLCPP_SMART_PTR_DEFINITIONS(Waitable) virtual ~Waitable(); };
class GuardCondition { public: RCLCPP_SMART_PTR_DEFINITIONS(GuardCondition) template <class... A> GuardCondition(const A&...); void trigger(); };
class NodeOptions {
public:
  NodeOptions(); template <class A> explicit NodeOptions(const A&); NodeOptions(const NodeOptions&); NodeOptions& operator=(const NodeOptions&);
  NodeOptions& arguments(const std::vector<std::string>&); const std::vector<std::string>& arguments() const;
  std::vector<Parameter>& parameter_overrides(); const std::vector<Parameter>& parameter_overrides() const; NodeOptions& parameter_overrides(const std::vector<Parameter>&);
  template <class V> NodeOptions& append_parameter_override(const std::string& name, const V& value);
  NodeOptions& use_global_arguments(bool); bool use_intra_process_comms() const; NodeOptions& use_intra_process_comms(bool); NodeOptions& enable_topic_statistics(bool);
  NodeOptions& start_parameter_services(bool); NodeOptions& start_parameter_event_publisher(bool); NodeOptions& clock_type(rcl_clock_type_t); NodeOptions& enable_rosout(bool);
  NodeOptions& allow_undeclared_parameters(bool); bool allow_undeclared_parameters() const; NodeOptions& automatically_declare_parameters_from_overrides(bool);
  bool automatically_declare_parameters_from_overrides() const; NodeOptions& use_clock_thread(bool); NodeOptions& clock_qos(const QoS&); NodeOptions& parameter_event_qos(const QoS&);
  NodeOptions& rosout_qos(const QoS&); template <class A> NodeOptions& context(const A&); NodeOptions& enable_logger_service(bool); bool enable_logger_service() const; bool use_global_arguments() const;
  bool enable_rosout() const; template <class A> NodeOptions& parameter_event_publisher_options(const A&);
};
namespace node_interfaces {
template <class... I> class NodeInterfaces { public: RCLCPP_SMART_PTR_DEFINITIONS(NodeInterfaces) template <class X> NodeInterfaces(X&); template <class X, class... Y> NodeInterfaces(const X&, const Y&...); };
struct OnSetParametersCallbackHandle { RCLCPP_SMART_PTR_DEFINITIONS(OnSetParametersCallbackHandle) std::function<rcl_interfaces::msg::SetParametersResult(const std::vector<Parameter>&)> callback; };
struct PreSetParametersCallbackHandle { RCLCPP_SMART_PTR_DEFINITIONS(PreSetParametersCallbackHandle) };
struct PostSetParametersCallbackHandle { RCLCPP_SMART_PTR_DEFINITIONS(PostSetParametersCallbackHandle) };
}
namespace detail { template <class T> struct rosarch_declared { typedef const T& type; }; template <> struct rosarch_declared<void> { typedef const ParameterValue& type; };
template <class T> struct rosarch_given { typedef T type; }; template <> struct rosarch_given<ParameterValue> { typedef const ParameterValue& type; };
template <> struct rosarch_given<ParameterType> { typedef const ParameterValue& type; };
template <> struct rosarch_given<const char*> { typedef std::string type; }; template <> struct rosarch_given<char*> { typedef std::string type; };
template <class T, class D> struct rosarch_result { typedef T type; }; template <class D> struct rosarch_result<void, D> { typedef typename rosarch_given<typename std::decay<D>::type>::type type; }; }
#define ROSARCH_PARAMETER_METHODS \
  template <class T = void, class N, class D, class... A> typename rclcpp::detail::rosarch_result<T, D>::type declare_parameter(const N& name, const D& default_value, \
    const A&... descriptor_and_ignore_override); \
  template <class T = void, class N> typename rclcpp::detail::rosarch_declared<T>::type declare_parameter(const N& name); \
  template <class T = void, class N> typename rclcpp::detail::rosarch_declared<T>::type declare_parameter(const N& name, rcl_interfaces::msg::ParameterDescriptor descriptor, \
    bool ignore_override = false); \
  template <class T, class N> std::vector<T> declare_parameters(const N& namespace_, const std::map<std::string, T>& parameters, bool = false); \
  template <class N> void undeclare_parameter(const N& name); \
  template <class N> bool has_parameter(const N& name) const; \
  rcl_interfaces::msg::SetParametersResult set_parameter(const rclcpp::Parameter& parameter); \
  std::vector<rcl_interfaces::msg::SetParametersResult> set_parameters(const std::vector<rclcpp::Parameter>& parameters); \
  rcl_interfaces::msg::SetParametersResult set_parameters_atomically(const std::vector<rclcpp::Parameter>& parameters); \
  template <class N> rclcpp::Parameter get_parameter(const N& name) const; \
  template <class V, class N> bool get_parameter(const N& name, V& parameter) const; \
  template <class V, class N, class D> bool get_parameter_or(const N& name, V& parameter, const D& alternative_value) const; \
  template <class D, class N> D get_parameter_or(const N& name, const D& alternative_value) const; \
  std::vector<rclcpp::Parameter> get_parameters(const std::vector<std::string>& names) const; \
  template <class V, class N> bool get_parameters(const N& prefix, std::map<std::string, V>& values) const; \
  template <class N> rcl_interfaces::msg::ParameterDescriptor describe_parameter(const N& name) const; \
  std::vector<rcl_interfaces::msg::ParameterDescriptor> describe_parameters(const std::vector<std::string>& names) const; \
  std::vector<uint8_t> get_parameter_types(const std::vector<std::string>& names) const; \
  rcl_interfaces::msg::ListParametersResult list_parameters(const std::vector<std::string>& prefixes, uint64_t depth) const; \
  template <class F> std::shared_ptr<rclcpp::node_interfaces::OnSetParametersCallbackHandle> add_on_set_parameters_callback(F&& callback); \
  template <class F> std::shared_ptr<rclcpp::node_interfaces::PreSetParametersCallbackHandle> add_pre_set_parameters_callback(F&& callback); \
  template <class F> std::shared_ptr<rclcpp::node_interfaces::PostSetParametersCallbackHandle> add_post_set_parameters_callback(F&& callback); \
  template <class F> rosarch::any set_on_parameters_set_callback(F callback); \
  template <class H> void remove_on_set_parameters_callback(const H* handler); \
  template <class H> void remove_pre_set_parameters_callback(const H* handler); \
  template <class H> void remove_post_set_parameters_callback(const H* handler);
#define ROSARCH_PARAMETER_TYPES \
  typedef rclcpp::node_interfaces::OnSetParametersCallbackHandle OnSetParametersCallbackHandle; typedef rclcpp::node_interfaces::PreSetParametersCallbackHandle PreSetParametersCallbackHandle; \
  typedef rclcpp::node_interfaces::PostSetParametersCallbackHandle PostSetParametersCallbackHandle; \
  typedef std::function<rcl_interfaces::msg::SetParametersResult(const std::vector<rclcpp::Parameter>&)> OnSetParametersCallbackType, OnParametersSetCallbackType; \
  typedef std::function<void(std::vector<rclcpp::Parameter>&)> PreSetParametersCallbackType; typedef std::function<void(const std::vector<rclcpp::Parameter>&)> PostSetParametersCallbackType;
#define ROSARCH_GRAPH_METHODS \
  std::vector<std::string> get_node_names() const; std::map<std::string, std::vector<std::string>> get_topic_names_and_types() const; \
  std::map<std::string, std::vector<std::string>> get_service_names_and_types() const; \
  template <class... A> std::map<std::string, std::vector<std::string>> get_service_names_and_types_by_node(const A&...) const; \
  size_t count_publishers(const std::string& topic) const; size_t count_subscribers(const std::string& topic) const; \
  size_t count_clients(const std::string&) const; size_t count_services(const std::string&) const; \
  template <class... A> std::vector<rosarch::any> get_publishers_info_by_topic(const A&...) const; \
  template <class... A> std::vector<rosarch::any> get_subscriptions_info_by_topic(const A&...) const; \
  Event::SharedPtr get_graph_event(); template <class... A> void wait_for_graph_change(const A&...); \
  std::string resolve_topic_name(const std::string& name, bool only_expand = false) const;
namespace node_interfaces {
#define ROSARCH_INTERFACE(Name, ...) class Name { public: RCLCPP_SMART_PTR_DEFINITIONS(Name) virtual ~Name(); __VA_ARGS__ };
ROSARCH_INTERFACE(NodeBaseInterface, const char* get_name() const; const char* get_namespace() const; const char* get_fully_qualified_name() const;
  Context::SharedPtr get_context(); CallbackGroup::SharedPtr create_callback_group(CallbackGroupType, bool = true); CallbackGroup::SharedPtr get_default_callback_group();
  bool callback_group_in_node(CallbackGroup::SharedPtr); std::string resolve_topic_or_service_name(const std::string&, bool, bool = false) const; rosarch::any get_rcl_node_handle();)
ROSARCH_INTERFACE(NodeClockInterface, Clock::SharedPtr get_clock();)
ROSARCH_INTERFACE(NodeGraphInterface, ROSARCH_GRAPH_METHODS)
ROSARCH_INTERFACE(NodeLoggingInterface, Logger get_logger() const; const char* get_logger_name() const;)
ROSARCH_INTERFACE(NodeTimersInterface, template <class... A> void add_timer(const A&...);)
ROSARCH_INTERFACE(NodeTopicsInterface, std::string resolve_topic_name(const std::string&, bool = false) const; template <class... A> void add_publisher(const A&...);
  template <class... A> void add_subscription(const A&...);)
ROSARCH_INTERFACE(NodeServicesInterface, std::string resolve_service_name(const std::string&, bool = false) const; template <class... A> void add_client(const A&...);
  template <class... A> void add_service(const A&...);)
ROSARCH_INTERFACE(NodeParametersInterface, ROSARCH_PARAMETER_METHODS const std::map<std::string, ParameterValue>& get_parameter_overrides() const;
  template <class V> bool get_parameters_by_prefix(const std::string& prefix, std::map<std::string, V>& values) const;
  ROSARCH_PARAMETER_TYPES)
ROSARCH_INTERFACE(NodeTimeSourceInterface, )
ROSARCH_INTERFACE(NodeTypeDescriptionsInterface, )
ROSARCH_INTERFACE(NodeWaitablesInterface, template <class... A> void add_waitable(const A&...); template <class... A> void remove_waitable(const A&...);)
#undef ROSARCH_INTERFACE
template <class T> NodeParametersInterface::SharedPtr get_node_parameters_interface(T&&); template <class T> NodeTopicsInterface::SharedPtr get_node_topics_interface(T&&);
template <class T> NodeBaseInterface::SharedPtr get_node_base_interface(T&&); template <class T> NodeTimersInterface::SharedPtr get_node_timers_interface(T&&);
}
#define ROSARCH_INTERFACE_METHODS \
rclcpp::node_interfaces::NodeBaseInterface::SharedPtr get_node_base_interface(); rclcpp::node_interfaces::NodeBaseInterface::SharedPtr get_node_base_interface() const; \
rclcpp::node_interfaces::NodeClockInterface::SharedPtr get_node_clock_interface(); rclcpp::node_interfaces::NodeGraphInterface::SharedPtr get_node_graph_interface(); \
rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr get_node_logging_interface(); rclcpp::node_interfaces::NodeTimersInterface::SharedPtr get_node_timers_interface(); \
rclcpp::node_interfaces::NodeTopicsInterface::SharedPtr get_node_topics_interface(); rclcpp::node_interfaces::NodeServicesInterface::SharedPtr get_node_services_interface(); \
rclcpp::node_interfaces::NodeWaitablesInterface::SharedPtr get_node_waitables_interface(); rclcpp::node_interfaces::NodeParametersInterface::SharedPtr get_node_parameters_interface(); \
rclcpp::node_interfaces::NodeTimeSourceInterface::SharedPtr get_node_time_source_interface(); \
rclcpp::node_interfaces::NodeTypeDescriptionsInterface::SharedPtr get_node_type_descriptions_interface(); const NodeOptions& get_node_options() const; \
  const char* get_name() const; const char* get_namespace() const; const char* get_fully_qualified_name() const; Logger get_logger() const; \
  CallbackGroup::SharedPtr create_callback_group(CallbackGroupType, bool automatically_add_to_executor_with_node = true); \
  template <class F> void for_each_callback_group(const F&); Clock::SharedPtr get_clock(); Clock::ConstSharedPtr get_clock() const; Time now() const;
#define ROSARCH_PORT_METHODS(PUBLISHER) \
  template <class M, class Alloc = void, class P = void, class T, class Q, class... A> std::shared_ptr<PUBLISHER<M>> create_publisher(const T& topic, const Q& qos, const A&... options); \
  template <class M> std::shared_ptr<PUBLISHER<M>> create_publisher(const std::string& topic, const QoS& qos, const PublisherOptions& options = PublisherOptions()); \
  template <class M, class Cb = void, class Alloc = void, class S = void, class Ms = void, class T, class Q, class F, class... A> std::shared_ptr<Subscription<M>> \
    create_subscription(const T& topic, const Q& qos, const F& callback, const A&... options_and_memory_strategy); \
  template <class M, class F> std::shared_ptr<Subscription<M>> create_subscription(const std::string& topic, const QoS& qos, const F& callback, \
    const SubscriptionOptions& options = SubscriptionOptions(), const std::shared_ptr<void>& memory = nullptr); \
  template <class S, class N, class F, class... A> std::shared_ptr<Service<S>> create_service(const N& name, const F& callback, const A&... qos_and_group); \
  template <class S, class N, class... A> std::shared_ptr<Client<S>> create_client(const N& name, const A&... qos_and_group); \
  template <class P, class F, class... A> std::shared_ptr<rclcpp::WallTimer<F>> create_wall_timer(const P& period, const F& callback, const A&... group_and_autostart); \
  template <class P, class F, class... A> std::shared_ptr<rclcpp::GenericTimer<F>> create_timer(const P& period, const F& callback, const A&... group_and_autostart); \
  template <class T, class Y, class Q, class... A> std::shared_ptr<GenericPublisher> create_generic_publisher(const T& topic, const Y& type, const Q& qos, const A&...); \
  template <class T, class Y, class Q, class F, class... A> std::shared_ptr<GenericSubscription> create_generic_subscription(const T& topic, const Y& type, const Q& qos, \
    const F& callback, const A&...); \
  template <class N, class Y, class... A> std::shared_ptr<ClientBase> create_generic_client(const N& name, const Y& type, const A&...);
class Node : public std::enable_shared_from_this<Node> {
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Node)
  explicit Node(const std::string& node_name, const NodeOptions& options = NodeOptions());
  explicit Node(const std::string& node_name, const std::string& namespace_, const NodeOptions& options = NodeOptions());
  Node(const Node& other, const std::string& sub_namespace);
  virtual ~Node();
  ROSARCH_PORT_METHODS(Publisher)
  ROSARCH_PARAMETER_TYPES
  ROSARCH_PARAMETER_METHODS
  ROSARCH_GRAPH_METHODS
  ROSARCH_INTERFACE_METHODS
  Node::SharedPtr create_sub_node(const std::string& sub_namespace);
  const std::string& get_sub_namespace() const; const std::string& get_effective_namespace() const;
};
// free functions that do what the methods do, for any kind of node
template <class M, class N, class T, class Q, class... A> std::shared_ptr<Publisher<M>> create_publisher(N&& node, const T& topic, const Q& qos, const A&... options);
template <class M, class Alloc, class P, class N, class T, class Q, class... A> std::shared_ptr<P> create_publisher(N&& node, const T& topic, const Q& qos, const A&... options);
template <class M, class N, class X, class T, class Q, class... A> std::shared_ptr<Publisher<M>> create_publisher(const std::shared_ptr<N>& parameters, const std::shared_ptr<X>& topics,
  const T& topic, const Q& qos, const A&... options);
template <class M, class N, class T, class Q, class F, class... A> std::shared_ptr<Subscription<M>> create_subscription(N&& node, const T& topic, const Q& qos, const F& callback,
  const A&... options);
template <class M, class F, class N, class X, class T, class Q, class... A> std::shared_ptr<Subscription<M>> create_subscription(const std::shared_ptr<N>& parameters,
  const std::shared_ptr<X>& topics, const T& topic, const Q& qos, F&& callback, const A&... options);
template <class S, class N, class Name, class F, class... A> std::shared_ptr<Service<S>> create_service(N&& node, const Name& name, const F& callback, const A&... qos_and_group);
template <class S, class B, class G, class V, class Name, class... A> std::shared_ptr<Client<S>> create_client(const B&, const G&, const V&, const Name& name, const A&... qos_and_group);
template <class N, class C, class P, class F, class... A, typename std::enable_if<!std::is_convertible<N, Clock::SharedPtr>::value, int>::type = 0>
  std::shared_ptr<GenericTimer<F>> create_timer(N&& node, const C& clock, const P& period, const F& callback, const A&... group);
template <class P, class F, class... A> std::shared_ptr<GenericTimer<F>> create_timer(const Clock::SharedPtr& clock, const P& period, F callback, CallbackGroup::SharedPtr group,
  node_interfaces::NodeBaseInterface* base, node_interfaces::NodeTimersInterface* timers, bool autostart = true);
template <class P, class F, class... A> std::shared_ptr<WallTimer<F>> create_wall_timer(const P& period, const F& callback, const A&... group_base_timers);
template <class N, class T, class Y, class Q, class... A> std::shared_ptr<GenericPublisher> create_generic_publisher(N&& topics, const T& topic, const Y& type, const Q& qos, const A&...);
template <class N, class T, class Y, class Q, class F, class... A> std::shared_ptr<GenericSubscription> create_generic_subscription(N&& topics, const T& topic, const Y& type, const Q& qos,
  const F& callback, const A&...);
template <class M, class... A> bool wait_for_message(M& message, const A&...);
template <class S, class D> void copy_all_parameter_values(const S& source, const D& destination, bool override_existing_params = false);
template <class... A> std::string expand_topic_or_service_name(const A&...);
std::string extend_name_with_sub_namespace(const std::string& name, const std::string& sub_namespace);
class SyncParametersClient; class AsyncParametersClient;
#define ROSARCH_PARAMETERS_CLIENT(Name, Result) class Name { public: RCLCPP_SMART_PTR_DEFINITIONS(Name) template <class... A> Name(const A&...); \
  template <class... A> Result<std::vector<Parameter>> get_parameters(const std::vector<std::string>&, const A&...); template <class... A> Result<std::vector<ParameterType>> get_parameter_types(const std::vector<std::string>&, const A&...); \
  template <class T> T get_parameter(const std::string& name); template <class T> T get_parameter(const std::string& name, const T& default_value); bool has_parameter(const std::string&); \
  template <class... A> Result<std::vector<rcl_interfaces::msg::SetParametersResult>> set_parameters(const std::vector<Parameter>&, const A&...); \
  template <class... A> Result<rcl_interfaces::msg::SetParametersResult> set_parameters_atomically(const std::vector<Parameter>&, const A&...); \
  template <class... A> Result<rcl_interfaces::msg::ListParametersResult> list_parameters(const std::vector<std::string>&, const A&...); template <class... A> Result<rosarch::any> describe_parameters(const std::vector<std::string>&, const A&...); \
  template <class... A> Result<rosarch::any> load_parameters(const A&...); template <class... A> Result<rosarch::any> delete_parameters(const std::vector<std::string>&, const A&...); \
  template <class F, class... A> std::shared_ptr<Subscription<rcl_interfaces::msg::ParameterEvent>> on_parameter_event(const F& callback, const A&...); \
  bool service_is_ready() const; template <class T = std::chrono::nanoseconds> bool wait_for_service(T timeout = T(-1)); };
template <class T> using rosarch_at_once = T;
template <class T> using rosarch_later = std::shared_future<T>;
ROSARCH_PARAMETERS_CLIENT(SyncParametersClient, rosarch_at_once)
ROSARCH_PARAMETERS_CLIENT(AsyncParametersClient, rosarch_later)
struct ParameterCallbackHandle { RCLCPP_SMART_PTR_DEFINITIONS(ParameterCallbackHandle) std::string parameter_name, node_name; };
struct ParameterEventCallbackHandle { RCLCPP_SMART_PTR_DEFINITIONS(ParameterEventCallbackHandle) };
class ParameterEventHandler { public: RCLCPP_SMART_PTR_DEFINITIONS(ParameterEventHandler) template <class... A> ParameterEventHandler(const A&...);
  template <class N, class F, class... A> std::shared_ptr<ParameterCallbackHandle> add_parameter_callback(const N& name, const F& callback, const A&... node_name);
  template <class F> std::shared_ptr<ParameterEventCallbackHandle> add_parameter_event_callback(const F& callback); template <class H> void remove_parameter_callback(const H&);
  template <class H> void remove_parameter_event_callback(const H&); template <class... A> static bool get_parameter_from_event(const A&...);
  template <class... A> static std::vector<Parameter> get_parameters_from_event(const A&...); };
class ParameterService { public: RCLCPP_SMART_PTR_DEFINITIONS(ParameterService) template <class... A> ParameterService(const A&...); };
class TimeSource { public: template <class... A> TimeSource(const A&...); void attachNode(const std::shared_ptr<Node>&); template <class... A> void attachClock(const A&...); void detachNode(); };
class WaitSet { public: template <class... A> WaitSet(const A&...); template <class... A> rosarch::any wait(const A&...); template <class... A> void add_subscription(const A&...);
  template <class... A> void add_timer(const A&...); template <class... A> void add_guard_condition(const A&...); template <class... A> void remove_subscription(const A&...); };
}
