"""Behavior trees: the nodes of the trees that nodes carry out, with what the trees give their ports."""

from __future__ import annotations

from pathlib import Path

import pytest

from rosarch.analysis.method import Method
from rosarch.analysis.systems.analysis import analyze_systems
from rosarch.analysis.systems.launches import given
from rosarch.analysis.systems.requests import LaunchEnvironment, parse_request
from rosarch.extractor.behavior_trees import TreeNode, nodes_of
from rosarch.extractor.settings import Settings
from rosarch.models.system.model import SystemModel

MANIFEST = """<package format="3"><name>trees</name><version>1.0.0</version><description>d</description>
<maintainer email="a@example.com">m</maintainer><license>MIT</license><buildtool_depend>ament_cmake</buildtool_depend>
<depend>rclcpp</depend><depend>behaviortree_cpp</depend><depend>ament_index_cpp</depend><depend>std_msgs</depend><depend>std_srvs</depend>
<export><build_type>ament_cmake</build_type></export></package>
"""
CMAKE = """cmake_minimum_required(VERSION 3.8)
project(trees)
find_package(ament_cmake REQUIRED)
add_library(leaves SHARED src/leaves.cpp)
ament_target_dependencies(leaves rclcpp behaviortree_cpp std_msgs std_srvs)
add_executable(runner src/runner.cpp)
ament_target_dependencies(runner rclcpp behaviortree_cpp ament_index_cpp)
install(TARGETS runner DESTINATION lib/${PROJECT_NAME})
ament_package()
"""
LEAVES = """#include "behaviortree_cpp/bt_factory.h"
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/bool.hpp"
#include "std_srvs/srv/empty.hpp"
namespace trees {
template <class ServiceT>
class ServiceNode : public BT::ActionNodeBase {
public:
  ServiceNode(const std::string & tag, const std::string & service, const BT::NodeConfiguration & conf)
  : BT::ActionNodeBase(tag, conf), service_(service)
  {
    node_ = config().blackboard->template get<rclcpp::Node::SharedPtr>("node");
    std::string other;
    if (getInput("service_name", other)) {
      service_ = other;
    }
    client_ = node_->create_client<ServiceT>(service_);
  }
  BT::NodeStatus tick() override
  {
    client_->async_send_request(std::make_shared<typename ServiceT::Request>());
    return BT::NodeStatus::SUCCESS;
  }
  void halt() override {}
protected:
  std::string service_;
  rclcpp::Node::SharedPtr node_;
  typename rclcpp::Client<ServiceT>::SharedPtr client_;
};
class Clear : public ServiceNode<std_srvs::srv::Empty> {
public:
  using ServiceNode::ServiceNode;
  Clear(const std::string & tag, const std::string & service, const BT::NodeConfiguration & conf) : ServiceNode(tag, service, conf) {}
};
class Ready : public BT::ConditionNode {
public:
  Ready(const std::string & name, const BT::NodeConfiguration & conf) : BT::ConditionNode(name, conf)
  {
    node_ = config().blackboard->get<rclcpp::Node::SharedPtr>("node");
    getInput("topic", topic_);
    sub_ = node_->create_subscription<std_msgs::msg::Bool>(topic_, 1, [this](std_msgs::msg::Bool::SharedPtr m) {ready_ = m->data;});
  }
  static BT::PortsList providedPorts() { return {BT::InputPort<std::string>("topic", std::string("ready"), "where it is said")}; }
  BT::NodeStatus tick() override { return ready_ ? BT::NodeStatus::SUCCESS : BT::NodeStatus::FAILURE; }
private:
  bool ready_ = false;
  std::string topic_;
  rclcpp::Node::SharedPtr node_;
  rclcpp::Subscription<std_msgs::msg::Bool>::SharedPtr sub_;
};
}
BT_REGISTER_NODES(factory)
{
  BT::NodeBuilder builder = [](const std::string & name, const BT::NodeConfiguration & config)
    {
      return std::make_unique<trees::Clear>(name, "clear", config);
    };
  factory.registerBuilder<trees::Clear>("Clear", builder);
  factory.registerNodeType<trees::Ready>("Ready");
}
"""
RUNNER = """#include "ament_index_cpp/get_package_share_directory.hpp"
#include "behaviortree_cpp/bt_factory.h"
#include "rclcpp/rclcpp.hpp"
class Runner : public rclcpp::Node {
public:
  Runner() : rclcpp::Node("runner") {}
  void start()
  {
    file_ = declare_parameter("tree", ament_index_cpp::get_package_share_directory("trees") + "/trees/main.xml");
    BT::SharedLibrary loader;
    factory_.registerFromPlugin(loader.getOSName("leaves"));
    blackboard_ = BT::Blackboard::create();
    CLIENT
    tree_ = factory_.createTreeFromFile(file_, blackboard_);
    timer_ = create_wall_timer(std::chrono::milliseconds(100), [this]() {tree_.tickOnce();});
  }
private:
  std::string file_;
  BT::BehaviorTreeFactory factory_;
  BT::Blackboard::Ptr blackboard_;
  BT::Tree tree_;
  rclcpp::Node::SharedPtr client_node_;
  rclcpp::TimerBase::SharedPtr timer_;
};
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<Runner>();
  node->start();
  rclcpp::spin(node);
}
"""
OWN = 'blackboard_->set<rclcpp::Node::SharedPtr>("node", shared_from_this());'
CLIENT = """client_node_ = std::make_shared<rclcpp::Node>("runner_client");
    blackboard_->set<rclcpp::Node::SharedPtr>("node", client_node_);"""
MAIN = """<root BTCPP_format="4" main_tree_to_execute="Main">
  <BehaviorTree ID="Main">
    <Sequence name="all">
      <Ready/>
      <SubTree ID="Clearing" where="near/clear"/>
      <Action ID="Clear"/>
    </Sequence>
  </BehaviorTree>
  <BehaviorTree ID="Clearing"><Clear service_name="{where}"/></BehaviorTree>
  <BehaviorTree ID="Unused"><Clear service_name="never"/></BehaviorTree>
</root>
"""
OTHER = """<root BTCPP_format="4"><BehaviorTree ID="Other"><Sequence><Ready topic="/go"/><Clear service_name="{far}"/><Dance/></Sequence></BehaviorTree></root>
"""
ROS_LEAVES = """#include "behaviortree_ros2/bt_service_node.hpp"
#include "behaviortree_ros2/bt_topic_pub_node.hpp"
#include "behaviortree_ros2/plugins.hpp"
#include "std_msgs/msg/bool.hpp"
#include "std_srvs/srv/set_bool.hpp"
class Fan : public BT::RosServiceNode<std_srvs::srv::SetBool> {
public:
  Fan(const std::string & name, const BT::NodeConfig & conf, const BT::RosNodeParams & params)
  : BT::RosServiceNode<std_srvs::srv::SetBool>(name, conf, params) {}
  static BT::PortsList providedPorts() { return providedBasicPorts({BT::InputPort<bool>("data", "on or off")}); }
  bool setRequest(typename Request::SharedPtr & request) override { return static_cast<bool>(getInput("data", request->data)); }
  BT::NodeStatus onResponseReceived(const typename Response::SharedPtr &) override { return BT::NodeStatus::SUCCESS; }
};
CreateRosNodePlugin(Fan, "Fan");
"""
ROS_SENDER = """#include "behaviortree_ros2/bt_topic_pub_node.hpp"
#include "behaviortree_ros2/plugins.hpp"
#include "std_msgs/msg/bool.hpp"
class Say : public BT::RosTopicPubNode<std_msgs::msg::Bool> {
public:
  using BT::RosTopicPubNode<std_msgs::msg::Bool>::RosTopicPubNode;
  bool setMessage(std_msgs::msg::Bool & msg) override { msg.data = true; return true; }
};
BTCPP_EXPORT void BT_RegisterRosNodeFromPlugin(BT::BehaviorTreeFactory & factory, const BT::RosNodeParams & params)
{
  factory.registerNodeType<Say>("Say", params);
}
"""
ROS_RUNNER = """#include "behaviortree_ros2/plugins.hpp"
class Runner : public rclcpp::Node {
public:
  Runner() : rclcpp::Node("runner") { declare_parameter("tree", ""); }
  void start()
  {
    BT::RosNodeParams params;
    params.nh = shared_from_this();
    RegisterRosNode(factory_, BT::SharedLibrary::getOSName("fan"), params);
    RegisterRosNode(factory_, BT::SharedLibrary::getOSName("say"), params);
    factory_.registerBehaviorTreeFromFile(get_parameter("tree").as_string());
    tree_ = factory_.createTree("Main");
  }
private:
  BT::BehaviorTreeFactory factory_;
  BT::Tree tree_;
};
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<Runner>();
  node->start();
  rclcpp::spin(node);
}
"""
ROS_TREE = """<root BTCPP_format="4"><BehaviorTree ID="Main"><Sequence>
  <Fan service_name="fan/enable" data="true"/><Fan service_name="fan/boost" data="true"/><Say topic_name="/warm"/>
</Sequence></BehaviorTree></root>
"""
ROS_CMAKE = """cmake_minimum_required(VERSION 3.8)
project(trees)
find_package(ament_cmake REQUIRED)
foreach(leaf fan say)
  add_library(${leaf} SHARED src/${leaf}.cpp)
  ament_target_dependencies(${leaf} rclcpp behaviortree_cpp behaviortree_ros2 std_msgs std_srvs)
endforeach()
add_executable(runner src/runner.cpp)
ament_target_dependencies(runner rclcpp behaviortree_cpp behaviortree_ros2)
install(TARGETS runner DESTINATION lib/${PROJECT_NAME})
ament_package()
"""
LAUNCH = """from launch import LaunchDescription
from launch_ros.actions import Node
def generate_launch_description():
    return LaunchDescription([Node(package='trees', executable='runner', name='robot', namespace='r1'PARAMETERS)])
"""


def _system(
    folder: Path, client: str = OWN, parameters: str = "", trees: dict[str, str] | None = None, others: dict[str, str] | None = None
) -> SystemModel:
    files = {"package.xml": MANIFEST, "CMakeLists.txt": CMAKE, "src/leaves.cpp": LEAVES, "src/runner.cpp": RUNNER.replace("CLIENT", client)}
    files |= {f"trees/{name}": text for name, text in (trees or {"main.xml": MAIN, "other.xml": OTHER}).items()}
    files |= others or {}
    files["launch/all.launch.py"] = LAUNCH.replace("PARAMETERS", parameters)
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    where = LaunchEnvironment(folder, (folder,), {})
    (system,) = analyze_systems(folder, given([parse_request("launch/all.launch.py")], where), Method(sources=Settings(jobs=1))).systems
    return system


def _ports(system: SystemModel, node: str) -> set[tuple[str, str]]:
    return {(port.kind, port.name or "?") for each in system.nodes if each.name == node for port in each.ports if not port.implicit}


@pytest.mark.slow
def test_nodes_of_a_tree_use_the_node_that_carries_it_out(tmp_path: Path) -> None:
    system = _system(tmp_path)
    assert [node.name for node in system.nodes] == ["/r1/robot"]
    assert _ports(system, "/r1/robot") == {
        ("subscriber", "/r1/ready"),
        ("service_client", "/r1/near/clear"),
        ("service_client", "/r1/clear"),
    }
    assert not any("tree" in part.reason for part in system.unseen)


@pytest.mark.slow
def test_nodes_of_a_tree_use_a_node_made_for_them(tmp_path: Path) -> None:
    system = _system(tmp_path, CLIENT)
    assert not _ports(system, "/r1/robot")
    assert ("subscriber", "/r1/ready") in _ports(system, "/r1/runner_client")


@pytest.mark.slow
def test_a_parameter_chooses_the_tree(tmp_path: Path) -> None:
    file = ", parameters=[{'tree': '" + str(tmp_path / "trees/other.xml") + "'}]"
    system = _system(tmp_path, parameters=file)
    assert _ports(system, "/r1/robot") == {("subscriber", "/go"), ("service_client", "/r1/clear")}
    assert {part.reason for part in system.unseen if "tree" in part.reason} == {"its behavior tree has nodes that were not seen: Dance"}


@pytest.mark.slow
def test_a_tree_that_cannot_be_read_is_told(tmp_path: Path) -> None:
    system = _system(tmp_path, trees={"main.xml": "<root><BehaviorTree>"})
    assert {part.reason for part in system.unseen} == {"not all of the behavior tree was read: package://trees/trees/main.xml"}


@pytest.mark.slow
def test_leaves_of_behaviortree_ros2_have_the_ports_that_the_tree_names(tmp_path: Path) -> None:
    others = {"CMakeLists.txt": ROS_CMAKE, "src/runner.cpp": ROS_RUNNER, "src/fan.cpp": ROS_LEAVES, "src/say.cpp": ROS_SENDER}
    file = ", parameters=[{'tree': '" + str(tmp_path / "trees/main.xml") + "'}]"
    system = _system(tmp_path, parameters=file, trees={"main.xml": ROS_TREE}, others=others)
    assert _ports(system, "/r1/robot") == {
        ("service_client", "/r1/fan/enable"),
        ("service_client", "/r1/fan/boost"),
        ("publisher", "/warm"),
    }
    assert not any("tree" in part.reason for part in system.unseen)


@pytest.mark.parametrize(
    ("text", "nodes", "whole"),
    [
        ('<root><BehaviorTree ID="A"><X p="1" name="n" _skipIf="a"/></BehaviorTree></root>', [TreeNode("X", (("p", "1"),))], True),
        ('<root><BehaviorTree ID="A"><SubTree ID="B"/></BehaviorTree></root>', [], False),
        ('<root main_tree_to_execute="A"><BehaviorTree ID="A"><SubTree ID="A"/></BehaviorTree></root>', [], False),
        ("<root/>", [], True),
        ("no tree", [], False),
    ],
)
def test_reading_trees(tmp_path: Path, text: str, nodes: list[TreeNode], whole: bool) -> None:
    file = tmp_path / "tree.xml"
    file.write_text(text, encoding="utf-8")
    assert nodes_of([file]) == (tuple(nodes), whole)


def test_trees_of_other_files(tmp_path: Path) -> None:
    (tmp_path / "a.xml").write_text(
        '<root><include path="b.xml"/><BehaviorTree ID="A"><SubTree ID="B"/></BehaviorTree></root>', encoding="utf-8"
    )
    (tmp_path / "b.xml").write_text('<root><include path="a.xml"/><BehaviorTree ID="B"><X/></BehaviorTree></root>', encoding="utf-8")
    assert nodes_of([tmp_path / "a.xml"]) == ((TreeNode("X", ()),), True)


def test_trees_that_contain_each_other_again_and_again(tmp_path: Path) -> None:
    file = tmp_path / "tree.xml"
    trees = "".join(f'<BehaviorTree ID="T{n}"><SubTree ID="T{n + 1}"/><SubTree ID="T{n + 1}"/></BehaviorTree>' for n in range(40))
    file.write_text(f'<root main_tree_to_execute="T0">{trees}<BehaviorTree ID="T40"><X/></BehaviorTree></root>', encoding="utf-8")
    assert nodes_of([file]) == ((TreeNode("X", ()),), True)
