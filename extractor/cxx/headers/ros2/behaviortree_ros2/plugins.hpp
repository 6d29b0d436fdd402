// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <behaviortree_cpp/bt_factory.h>
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_action/rclcpp_action.hpp>
#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
// BehaviorTree.ROS2: leaves of behavior trees that are clients, publishers and subscribers.
#define CreateRosNodePlugin(TYPE, REGISTRATION_NAME) \
  void BT_RegisterRosNodeFromPlugin(BT::BehaviorTreeFactory& factory, const BT::RosNodeParams& params) { factory.registerNodeType<TYPE>(REGISTRATION_NAME, params); }
namespace BT {
struct RosNodeParams {
  std::shared_ptr<rclcpp::Node> nh; std::string default_port_value; std::chrono::milliseconds server_timeout, wait_for_server_timeout;
  RosNodeParams(); RosNodeParams(std::shared_ptr<rclcpp::Node> node); RosNodeParams(std::shared_ptr<rclcpp::Node> node, const std::string& port_name);
};
void RegisterRosNode(BehaviorTreeFactory& factory, const std::filesystem::path& filepath, const RosNodeParams& params);
enum ServiceNodeErrorCode { SERVICE_UNREACHABLE, SERVICE_TIMEOUT, INVALID_REQUEST, SERVICE_ABORTED };
enum ActionNodeErrorCode { SERVER_UNREACHABLE, SEND_GOAL_TIMEOUT, GOAL_REJECTED_BY_SERVER, ACTION_ABORTED, ACTION_CANCELLED, INVALID_GOAL };
const char* toStr(const ServiceNodeErrorCode&); const char* toStr(const ActionNodeErrorCode&);
template <class ServiceT> class RosServiceNode : public ActionNodeBase {
 public:
  using ServiceClient = rclcpp::Client<ServiceT>; using Request = typename ServiceT::Request; using Response = typename ServiceT::Response;
  RosServiceNode(const std::string& instance_name, const NodeConfig& conf, const RosNodeParams& params);
  static PortsList providedBasicPorts(PortsList addition); static PortsList providedPorts(); NodeStatus tick() override; void halt() override;
  virtual bool setRequest(typename Request::SharedPtr& request) = 0; virtual NodeStatus onResponseReceived(const typename Response::SharedPtr& response) = 0;
  virtual NodeStatus onFailure(ServiceNodeErrorCode error); void setServiceName(const std::string&);
 protected:
  std::shared_ptr<rclcpp::Node> node_; std::string service_name_, prev_service_name_; bool service_name_should_be_checked_, service_name_may_change_;
  const std::chrono::milliseconds service_timeout_, wait_for_service_timeout_; rclcpp::Logger logger(); rclcpp::Time now();
};
template <class ActionT> class RosActionNode : public ActionNodeBase {
 public:
  using ActionType = ActionT; using Goal = typename ActionT::Goal; using Feedback = typename ActionT::Feedback; using GoalHandle = rclcpp_action::ClientGoalHandle<ActionT>;
  using WrappedResult = typename rclcpp_action::ClientGoalHandle<ActionT>::WrappedResult; using ActionClient = rclcpp_action::Client<ActionT>;
  RosActionNode(const std::string& instance_name, const NodeConfig& conf, const RosNodeParams& params);
  static PortsList providedBasicPorts(PortsList addition); static PortsList providedPorts(); NodeStatus tick() override; void halt() override; void cancelGoal();
  virtual void onHalt(); virtual bool setGoal(Goal& goal) = 0; virtual NodeStatus onResultReceived(const WrappedResult& result) = 0;
  virtual NodeStatus onFeedback(const std::shared_ptr<const Feedback> feedback); virtual NodeStatus onFailure(ActionNodeErrorCode error); void setActionName(const std::string&);
 protected:
  std::shared_ptr<rclcpp::Node> node_; std::string action_name_, prev_action_name_; bool action_name_may_change_;
  const std::chrono::milliseconds server_timeout_, wait_for_server_timeout_; rclcpp::Logger logger(); rclcpp::Time now();
};
template <class TopicT> class RosTopicPubNode : public ConditionNode {
 public:
  using Publisher = rclcpp::Publisher<TopicT>;
  RosTopicPubNode(const std::string& instance_name, const NodeConfig& conf, const RosNodeParams& params);
  static PortsList providedBasicPorts(PortsList addition); static PortsList providedPorts(); NodeStatus tick() override;
  virtual bool setMessage(TopicT& msg) = 0;
 protected:
  std::shared_ptr<rclcpp::Node> node_; std::string prev_topic_name_; bool topic_name_may_change_; rclcpp::Logger logger(); rclcpp::Time now();
};
template <class TopicT> class RosTopicSubNode : public ConditionNode {
 public:
  using Subscriber = rclcpp::Subscription<TopicT>;
  RosTopicSubNode(const std::string& instance_name, const NodeConfig& conf, const RosNodeParams& params);
  static PortsList providedBasicPorts(PortsList addition); static PortsList providedPorts(); NodeStatus tick() override;
  virtual NodeStatus onTick(const std::shared_ptr<TopicT>& last_msg) = 0; virtual bool latchLastMessage() const;
 protected:
  std::shared_ptr<rclcpp::Node> node_; std::shared_ptr<TopicT> last_msg_; std::string topic_name_; rclcpp::Logger logger(); rclcpp::Time now();
};
}
