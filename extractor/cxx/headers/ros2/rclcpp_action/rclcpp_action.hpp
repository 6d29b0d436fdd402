// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <rclcpp/rclcpp.hpp>
#include <action_msgs/msg/goal_info.hpp>
#include <action_msgs/msg/goal_status.hpp>
#include <action_msgs/srv/cancel_goal.hpp>
#define RCLCPP_ACTION_PUBLIC
typedef struct rcl_action_server_options_s { rmw_qos_profile_t goal_service_qos, cancel_service_qos, result_service_qos, feedback_topic_qos, status_topic_qos; } rcl_action_server_options_t;
typedef struct rcl_action_client_options_s { rmw_qos_profile_t goal_service_qos, result_service_qos, cancel_service_qos, feedback_topic_qos, status_topic_qos; } rcl_action_client_options_t;
rcl_action_server_options_t rcl_action_server_get_default_options(void); rcl_action_client_options_t rcl_action_client_get_default_options(void);
namespace rclcpp_action {
typedef std::array<uint8_t, 16> GoalUUID;
std::string to_string(const GoalUUID&);
enum class GoalResponse : int8_t { REJECT = 1, ACCEPT_AND_EXECUTE = 2, ACCEPT_AND_DEFER = 3 };
enum class CancelResponse : int8_t { REJECT = 1, ACCEPT = 2 };
enum class ResultCode : int8_t { UNKNOWN = 0, SUCCEEDED = 4, CANCELED = 5, ABORTED = 6 };
enum class GoalStatus : int8_t { UNKNOWN, ACCEPTED, EXECUTING, CANCELING, SUCCEEDED, CANCELED, ABORTED };
namespace exceptions { struct UnknownGoalHandleError : public std::invalid_argument { UnknownGoalHandleError(); }; struct UnawareGoalHandleError : public std::runtime_error { UnawareGoalHandleError(const std::string& = ""); }; }
class ServerBase { public: RCLCPP_SMART_PTR_DEFINITIONS(ServerBase) virtual ~ServerBase(); template <class... A> void configure_introspection(const A&...); };
template <class T> class ServerGoalHandle { public: RCLCPP_POINTERS(ServerGoalHandle)
  typedef typename T::Goal Goal; typedef typename T::Result Result; typedef typename T::Feedback Feedback;
  template <class X> void publish_feedback(X&& feedback); template <class X> void abort(X&& result); template <class X> void succeed(X&& result); template <class X> void canceled(X&& result);
  void execute(); const std::shared_ptr<const Goal> get_goal() const; const GoalUUID& get_goal_id() const; bool is_canceling() const; bool is_active() const; bool is_executing() const; };
template <class T> class Server : public ServerBase { public: RCLCPP_POINTERS(Server)
  typedef std::function<GoalResponse(const GoalUUID&, std::shared_ptr<const typename T::Goal>)> GoalCallback;
  typedef std::function<CancelResponse(std::shared_ptr<ServerGoalHandle<T>>)> CancelCallback; typedef std::function<void(std::shared_ptr<ServerGoalHandle<T>>)> AcceptedCallback;
  template <class... A> Server(const A&...); };
class ClientBase { public: RCLCPP_SMART_PTR_DEFINITIONS(ClientBase) virtual ~ClientBase(); bool action_server_is_ready() const;
  template <class D = std::chrono::nanoseconds> bool wait_for_action_server(D timeout = D(-1)); template <class... A> void configure_introspection(const A&...); };
template <class T> class ClientGoalHandle { public: RCLCPP_POINTERS(ClientGoalHandle)
  typedef typename T::Result Result; typedef typename T::Feedback Feedback;
  struct WrappedResult { GoalUUID goal_id; ResultCode code; typename T::Result::SharedPtr result; };
  typedef std::function<void(typename ClientGoalHandle<T>::SharedPtr, const std::shared_ptr<const Feedback>)> FeedbackCallback; typedef std::function<void(const WrappedResult&)> ResultCallback;
  const GoalUUID& get_goal_id() const; rclcpp::Time get_goal_stamp() const; int8_t get_status(); bool is_feedback_aware(); bool is_result_aware();
  std::shared_future<WrappedResult> async_get_result(); };
template <class T> class Client : public ClientBase { public: RCLCPP_POINTERS(Client)
  typedef typename T::Goal Goal; typedef typename T::Feedback Feedback; typedef ClientGoalHandle<T> GoalHandle; typedef typename GoalHandle::WrappedResult WrappedResult;
  typedef std::function<void(typename GoalHandle::SharedPtr)> GoalResponseCallback; typedef typename GoalHandle::FeedbackCallback FeedbackCallback; typedef typename GoalHandle::ResultCallback ResultCallback;
  typedef action_msgs::srv::CancelGoal::Request CancelRequest; typedef action_msgs::srv::CancelGoal::Response CancelResponse; typedef std::function<void(CancelResponse::SharedPtr)> CancelCallback;
  // the callbacks are plain objects: what is assigned to them is a fact like any other
  struct SendGoalOptions { SendGoalOptions(); GoalResponseCallback goal_response_callback; FeedbackCallback feedback_callback; ResultCallback result_callback; };
  template <class... A> Client(const A&...);
  template <class G, class... A> std::shared_future<typename GoalHandle::SharedPtr> async_send_goal(G&& goal, const A&... options);
  template <class H, class... A> std::shared_future<WrappedResult> async_get_result(H&& handle, const A&... callback);
  template <class H, class... A> std::shared_future<typename CancelResponse::SharedPtr> async_cancel_goal(H&& handle, const A&... callback);
  template <class... A> std::shared_future<typename CancelResponse::SharedPtr> async_cancel_all_goals(const A&... callback);
  template <class S, class... A> std::shared_future<typename CancelResponse::SharedPtr> async_cancel_goals_before(const S& stamp, const A&... callback);
  template <class H> void stop_callbacks(const H&); };
// (node, name, ...) or (four interfaces of a node, name, ...)
template <class T, class... A> typename Server<T>::SharedPtr create_server(A&&... node_name_goal_cancel_accepted_options_group);
template <class T, class... A> typename Client<T>::SharedPtr create_client(A&&... node_name_group_options);
}
