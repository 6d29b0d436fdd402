// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <any>
#include <chrono>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <unordered_map>
#include <utility>
#include <vector>
// BehaviorTree.CPP, versions 3 and 4: what their leaves are written with.
#define BT_REGISTER_NODES(factory) void BT_RegisterNodesFromPlugin(BT::BehaviorTreeFactory& factory)
#define BTCPP_EXPORT
namespace BT {
enum class NodeStatus { IDLE = 0, RUNNING = 1, SUCCESS = 2, FAILURE = 3, SKIPPED = 4 };
enum class NodeType { UNDEFINED = 0, ACTION, CONDITION, CONTROL, DECORATOR, SUBTREE };
enum class PortDirection { INPUT, OUTPUT, INOUT };
using StringView = std::string;
struct AnyTypeAllowed {};
class RuntimeError : public std::runtime_error { public: template <class... A> RuntimeError(const A&...); };
class LogicError : public std::runtime_error { public: template <class... A> LogicError(const A&...); };
class BehaviorTreeException : public std::exception { public: template <class... A> BehaviorTreeException(const A&...); };
struct FailedNode { std::string registration_name, node_path; };
class NodeExecutionError : public RuntimeError { public: FailedNode failedNode() const; std::string originalMessage() const; };
std::string toStr(NodeStatus, bool colored = false); template <class T> std::string toStr(const T&);
template <class T> T convertFromString(StringView); std::vector<StringView> splitString(const StringView&, char);
template <class T> struct Expected {
  bool has_value() const; explicit operator bool() const; T& value(); const T& value() const; T value_or(T) const; std::string error() const; T& operator*(); T* operator->();
};
using Result = Expected<std::string>;
class Any { public: template <class T> T cast() const; template <class T> T* castPtr(); bool empty() const; bool isString() const; bool isNumber() const; };
class PortInfo { public: PortDirection direction() const; const std::string& description() const; std::string defaultValueString() const; };
using PortsList = std::unordered_map<std::string, PortInfo>;
using PortsRemapping = std::unordered_map<std::string, std::string>;
template <class T = AnyTypeAllowed> std::pair<std::string, PortInfo> InputPort(StringView name, StringView description = {});
template <class T = AnyTypeAllowed, class D = T> std::pair<std::string, PortInfo> InputPort(StringView name, const D& default_value, StringView description);
template <class T = AnyTypeAllowed> std::pair<std::string, PortInfo> OutputPort(StringView name, StringView description = {});
template <class T = AnyTypeAllowed> std::pair<std::string, PortInfo> OutputPort(StringView name, StringView default_value, StringView description);
template <class T = AnyTypeAllowed> std::pair<std::string, PortInfo> BidirectionalPort(StringView name, StringView description = {});
template <class T = AnyTypeAllowed, class D = T> std::pair<std::string, PortInfo> BidirectionalPort(StringView name, const D& default_value, StringView description);
class Blackboard {
 public:
  using Ptr = std::shared_ptr<Blackboard>;
  static Ptr create(Ptr parent = {});
  template <class T> T get(const std::string& key) const;
  template <class T> bool get(const std::string& key, T& value) const;
  template <class T> void set(const std::string& key, const T& value);
  const Any* getAny(const std::string& key) const; void addSubtreeRemapping(StringView, StringView); void unset(const std::string& key); Ptr parent(); Blackboard* rootBlackboard();
};
struct TreeNodeManifest { NodeType type; std::string registration_ID; PortsList ports; };
struct NodeConfig { Blackboard::Ptr blackboard; PortsRemapping input_ports; PortsRemapping output_ports; const TreeNodeManifest* manifest = nullptr; std::string path; unsigned short uid = 0; };
using NodeConfiguration = NodeConfig;
class TreeNode {
 public:
  using Ptr = std::shared_ptr<TreeNode>;
  using StatusChangeSignal = int; using StatusChangeSubscriber = std::shared_ptr<int>; using StatusChangeCallback = std::function<void(std::chrono::high_resolution_clock::duration, const TreeNode&, NodeStatus, NodeStatus)>;
  TreeNode(std::string name, NodeConfig config); virtual ~TreeNode();
  virtual NodeStatus executeTick(); virtual void halt() = 0; void haltNode(); bool isHalted() const; NodeStatus status() const; const std::string& name() const;
  NodeStatus waitValidStatus(); virtual NodeType type() const; unsigned short UID() const; const std::string& fullPath() const; const std::string& registrationName() const; const NodeConfig& config() const;
  template <class T> Result getInput(const std::string& key, T& destination) const;
  template <class T> Expected<T> getInput(const std::string& key) const;
  template <class T> Result setOutput(const std::string& key, const T& value);
  void emitWakeUpSignal(); bool requiresWakeUp() const; template <class F> StatusChangeSubscriber subscribeToStatusChange(F);
 protected:
  virtual NodeStatus tick() = 0; void resetStatus(); void setStatus(NodeStatus); void setRegistrationID(StringView); NodeConfig& config();
};
class LeafNode : public TreeNode { public: LeafNode(const std::string& name, const NodeConfig& config); };
class ActionNodeBase : public LeafNode { public: ActionNodeBase(const std::string& name, const NodeConfig& config); };
class SyncActionNode : public ActionNodeBase { public: SyncActionNode(const std::string& name, const NodeConfig& config); NodeStatus executeTick() override; void halt() override; };
class SimpleActionNode : public SyncActionNode { public: using TickFunctor = std::function<NodeStatus(TreeNode&)>; SimpleActionNode(const std::string& name, TickFunctor tick, const NodeConfig& config); };
class ThreadedAction : public ActionNodeBase { public: ThreadedAction(const std::string& name, const NodeConfig& config); bool isHaltRequested() const; NodeStatus executeTick() override; void halt() override; };
using AsyncActionNode = ThreadedAction;
class StatefulActionNode : public ActionNodeBase {
 public:
  StatefulActionNode(const std::string& name, const NodeConfig& config);
  virtual NodeStatus onStart() = 0; virtual NodeStatus onRunning() = 0; virtual void onHalted() = 0; bool isHaltRequested() const;
 protected:
  NodeStatus tick() override; void halt() override;
};
class CoroActionNode : public ActionNodeBase { public: CoroActionNode(const std::string& name, const NodeConfig& config); void setStatusRunningAndYield(); NodeStatus executeTick() override; void halt() override; };
class ConditionNode : public LeafNode { public: ConditionNode(const std::string& name, const NodeConfig& config); void halt() override; };
class SimpleConditionNode : public ConditionNode { public: using TickFunctor = std::function<NodeStatus(TreeNode&)>; SimpleConditionNode(const std::string& name, TickFunctor tick, const NodeConfig& config); };
class DecoratorNode : public TreeNode {
 protected:
  TreeNode* child_node_;
 public:
  DecoratorNode(const std::string& name, const NodeConfig& config); void setChild(TreeNode*); const TreeNode* child() const; TreeNode* child(); void halt() override; void haltChild(); void resetChild(); NodeStatus executeTick() override;
};
class ControlNode : public TreeNode {
 protected:
  std::vector<TreeNode*> children_nodes_;
 public:
  ControlNode(const std::string& name, const NodeConfig& config); void addChild(TreeNode*); size_t childrenCount() const; const std::vector<TreeNode*>& children() const; const TreeNode* child(size_t) const;
  void halt() override; void haltChildren(); void haltChild(size_t); void resetChildren();
};
using NodeBuilder = std::function<std::unique_ptr<TreeNode>(const std::string&, const NodeConfig&)>;
template <class T> NodeBuilder CreateBuilder(); template <class T> TreeNodeManifest CreateManifest(const std::string&);
class Tree {
 public:
  struct Subtree { using Ptr = std::shared_ptr<Subtree>; std::vector<TreeNode::Ptr> nodes; Blackboard::Ptr blackboard; std::string instance_name, tree_ID; };
  std::vector<Subtree::Ptr> subtrees; std::vector<TreeNode::Ptr> nodes; std::vector<Blackboard::Ptr> blackboard_stack;
  void initialize(); void haltTree(); TreeNode* rootNode() const; NodeStatus tickRoot(); NodeStatus tickExactlyOnce(); NodeStatus tickOnce();
  NodeStatus tickWhileRunning(std::chrono::milliseconds sleep_time = std::chrono::milliseconds(10)); bool sleep(std::chrono::system_clock::duration); void emitWakeUpSignal(); Blackboard::Ptr rootBlackboard();
  void applyVisitor(const std::function<void(const TreeNode*)>&) const; void applyVisitor(const std::function<void(TreeNode*)>&);
};
class BehaviorTreeFactory {
 public:
  BehaviorTreeFactory(); bool unregisterBuilder(const std::string& ID); const std::unordered_map<std::string, TreeNodeManifest>& manifests() const; const std::unordered_map<std::string, NodeBuilder>& builders() const;
  void registerBuilder(const TreeNodeManifest&, const NodeBuilder&); template <class T> void registerBuilder(const std::string& ID, const NodeBuilder& builder);
  void registerSimpleAction(const std::string& ID, const SimpleActionNode::TickFunctor& tick, PortsList ports = {});
  void registerSimpleCondition(const std::string& ID, const SimpleConditionNode::TickFunctor& tick, PortsList ports = {});
  template <class F> void registerSimpleDecorator(const std::string& ID, const F& tick, PortsList ports = {});
  template <class T, class... A> void registerNodeType(const std::string& ID, A... args);
  void registerFromPlugin(const std::string& file_path); void registerFromROSPlugins();
  void registerBehaviorTreeFromFile(const std::string& filename); void registerBehaviorTreeFromText(const std::string& xml_text); std::vector<std::string> registeredBehaviorTrees() const; void clearRegisteredBehaviorTrees();
  Tree createTreeFromText(const std::string& text, Blackboard::Ptr blackboard = Blackboard::create());
  Tree createTreeFromFile(const std::string& file_path, Blackboard::Ptr blackboard = Blackboard::create());
  Tree createTree(const std::string& tree_name, Blackboard::Ptr blackboard = Blackboard::create());
};
class SharedLibrary { public: SharedLibrary(); SharedLibrary(const std::string& path, int flags = 0); void load(const std::string& path, int flags = 0); void unload(); static std::string getOSName(const std::string& name); };
class StatusChangeLogger {
 public:
  StatusChangeLogger(TreeNode* root_node); virtual ~StatusChangeLogger();
  virtual void callback(std::chrono::microseconds timestamp, const TreeNode& node, NodeStatus prev_status, NodeStatus status) = 0; virtual void flush() = 0; void setEnabled(bool); bool enabled() const;
};
class StdCoutLogger : public StatusChangeLogger { public: StdCoutLogger(const Tree&); void callback(std::chrono::microseconds, const TreeNode&, NodeStatus, NodeStatus) override; void flush() override; };
class FileLogger2 { public: FileLogger2(const Tree&, const std::string&); };
class Groot2Publisher { public: Groot2Publisher(const Tree&, unsigned server_port = 1667); void setEnabled(bool); };
class PublisherZMQ { public: PublisherZMQ(const Tree&, unsigned max_msg_per_second = 25, unsigned publisher_port = 1666, unsigned server_port = 1667); };
std::string writeTreeNodesModelXML(const BehaviorTreeFactory&, bool include_builtin = false); template <class T> void RegisterJsonDefinition();
void haltAllActions(TreeNode*); void printTreeRecursively(const TreeNode*); void applyRecursiveVisitor(const TreeNode*, const std::function<void(const TreeNode*)>&); void applyRecursiveVisitor(TreeNode*, const std::function<void(TreeNode*)>&);
}
