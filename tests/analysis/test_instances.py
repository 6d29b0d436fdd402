"""Nodes as their components with their configurations: parameters, names, plug-ins and nodes within nodes."""

from __future__ import annotations

from pathlib import Path

import pytest

from rosarch.analysis.method import Method
from rosarch.analysis.systems.analysis import analyze_systems
from rosarch.analysis.systems.launches import given
from rosarch.analysis.systems.requests import LaunchEnvironment, parse_request
from rosarch.extractor.settings import Settings
from rosarch.models.component import component_of
from rosarch.models.node_configuration import PluginArgument, arguments_of_plugin
from rosarch.models.system.model import SystemModel

MANIFEST = """<package format="3"><name>host</name><version>1.0.0</version><description>d</description>
<maintainer email="a@b.c">m</maintainer><license>MIT</license><buildtool_depend>ament_cmake</buildtool_depend>
<depend>rclcpp</depend><depend>pluginlib</depend><depend>std_msgs</depend>
<export><build_type>ament_cmake</build_type></export></package>
"""
CMAKE = """cmake_minimum_required(VERSION 3.8)
project(host)
find_package(ament_cmake REQUIRED)
find_package(rclcpp REQUIRED)
find_package(pluginlib REQUIRED)
add_executable(host src/host.cpp)
ament_target_dependencies(host rclcpp pluginlib std_msgs)
add_library(tools SHARED src/tools.cpp)
ament_target_dependencies(tools rclcpp pluginlib std_msgs)
pluginlib_export_plugin_description_file(host plugins.xml)
install(TARGETS host DESTINATION lib/${PROJECT_NAME})
ament_package()
"""
PLUGINS = """<library path="tools">
<class name="host::Left" type="host::Left" base_class_type="host::Tool"><description>l</description></class>
<class name="host::Right" type="host::Right" base_class_type="host::Tool"><description>r</description></class>
<class name="host::Still" type="host::Still" base_class_type="host::Tool"><description>s</description></class>
</library>
"""
HEADER = """#pragma once
#include <string>
#include "rclcpp/rclcpp.hpp"
namespace host {
enum class Need { NOTHING, CLOCK };
class Tool {
public:
  virtual ~Tool() {}
  virtual Need need() const = 0;
  virtual void configure(rclcpp::Node * node, const std::string & name) = 0;
};
}
"""
HOST = """#include "pluginlib/class_loader.hpp"
#include "std_msgs/msg/bool.hpp"
#include "std_msgs/msg/string.hpp"
#include "tool.hpp"
namespace host {
rclcpp::NodeOptions options(const std::string & parent, const std::string & name) {
  return rclcpp::NodeOptions().arguments({"--ros-args", "-r", "__ns:=" + parent + "/" + name});
}
class Grid : public rclcpp::Node {
public:
  Grid(const std::string & parent, const std::string & name) : rclcpp::Node(name, "", options(parent, name)) {
    grid_ = create_publisher<std_msgs::msg::Bool>(declare_parameter("topic", std::string("cells")), 1);
  }
private:
  rclcpp::Publisher<std_msgs::msg::Bool>::SharedPtr grid_;
};
class Host : public rclcpp::Node {
public:
  Host() : rclcpp::Node("host"), loader_("host", "host::Tool") {
    if (declare_parameter("chatty", true)) {
      chat_ = create_publisher<std_msgs::msg::String>(std::string(get_name()) + "/chat", 1);
    } else {
      quiet_ = create_publisher<std_msgs::msg::Bool>("quiet", 1);
    }
    own_ = declare_parameter("own", false);
    plan_ = create_publisher<std_msgs::msg::Bool>(std::string(!own_ ? "" : "~/") + "plan", 1);
    ids_ = declare_parameter("tools", std::vector<std::string>{});
    for (const auto & id : ids_) {
      auto tool = loader_.createSharedInstance(declare_parameter(id + ".plugin", std::string()));
      tool->configure(this, id);
      tools_.push_back(tool);
    }
    bool clock = false;
    for (const auto & tool : tools_) {
      const auto need = tool->need();
      if (need == Need::CLOCK) {
        clock = true;
      }
    }
    if (clock) {
      clock_ = create_publisher<std_msgs::msg::Bool>("clocked", 1);
    }
    grid_ = std::make_shared<Grid>(get_namespace(), "grid");
  }
private:
  pluginlib::ClassLoader<Tool> loader_;
  std::vector<std::shared_ptr<Tool>> tools_;
  std::vector<std::string> ids_;
  std::shared_ptr<Grid> grid_;
  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr chat_;
  rclcpp::Publisher<std_msgs::msg::Bool>::SharedPtr quiet_, plan_, clock_;
  bool own_;
};
}
int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<host::Host>());
}
"""
TOOLS = """#include "pluginlib/class_list_macros.hpp"
#include "std_msgs/msg/bool.hpp"
#include "tool.hpp"
namespace host {
class Left : public Tool {
public:
  Need need() const override { return Need::NOTHING; }
  void configure(rclcpp::Node * node, const std::string & name) override {
    pub_ = node->create_publisher<std_msgs::msg::Bool>(name + "/left", 1);
  }
private:
  rclcpp::Publisher<std_msgs::msg::Bool>::SharedPtr pub_;
};
template <class Message>
class Named : public Tool {};
template <class Message>
class Quiet : public Named<Message> {
public:
  Need need() const override { return Need::NOTHING; }
};
class Still : public Quiet<std_msgs::msg::Bool> {
public:
  void configure(rclcpp::Node * node, const std::string & name) override {}
};
class Right : public Tool {
public:
  Need need() const override { return Need::CLOCK; }
  void configure(rclcpp::Node * node, const std::string & name) override {
    pub_ = node->create_publisher<std_msgs::msg::Bool>(node->declare_parameter(name + ".topic", std::string("right")), 1);
  }
private:
  rclcpp::Publisher<std_msgs::msg::Bool>::SharedPtr pub_;
};
}
PLUGINLIB_EXPORT_CLASS(host::Left, host::Tool)
PLUGINLIB_EXPORT_CLASS(host::Right, host::Tool)
PLUGINLIB_EXPORT_CLASS(host::Still, host::Tool)
"""
LAUNCH = """from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='host', executable='host', name='one', namespace='arm', parameters=[{
            'chatty': False, 'own': True, 'tools': ['a', 'b'], 'a.plugin': 'host::Left', 'b.plugin': 'host::Right', 'b.topic': 'given'}]),
        Node(package='host', executable='host', name='two', parameters=[{'tools': ['a'], 'a.plugin': 'host::Right'}]),
        Node(package='host', executable='host', name='four', parameters=[{
            'tools': ['a', 'b'], 'a.plugin': 'host::Left', 'b.plugin': 'host::Still'}]),
        Node(package='host', executable='host', name='three', parameters=['__PARAMS__']),
    ])
"""
PARAMS = """three: {ros__parameters: {tools: []}}
grid: {grid: {ros__parameters: {topic: squares}}}
"""


@pytest.fixture(scope="module")
def system(tmp_path_factory: pytest.TempPathFactory) -> SystemModel:
    root = tmp_path_factory.mktemp("ws")
    package = root / "host"
    (package / "src").mkdir(parents=True)
    files = {"package.xml": MANIFEST, "CMakeLists.txt": CMAKE, "plugins.xml": PLUGINS, "params.yaml": PARAMS}
    files |= {"src/tool.hpp": HEADER, "src/host.cpp": HOST, "src/tools.cpp": TOOLS}
    files["main.launch.py"] = LAUNCH.replace("__PARAMS__", str(package / "params.yaml"))
    for name, text in files.items():
        (package / name).write_text(text)
    where = LaunchEnvironment(root, (root,), {})
    analysis = analyze_systems(root, given([parse_request("host/main.launch.py")], where), Method(sources=Settings(jobs=1)))
    return analysis.systems[0]


def ports_of(system: SystemModel, name: str) -> set[str]:
    (node,) = (node for node in system.nodes if node.name == name)
    return {port.name for port in node.ports if not port.implicit}


@pytest.mark.slow
def test_what_parameters_decide(system: SystemModel) -> None:
    assert ports_of(system, "/arm/one") == {"/arm/quiet", "/arm/one/plan", "/arm/a/left", "/arm/given", "/arm/clocked"}


@pytest.mark.slow
def test_defaults_and_the_name_that_the_launch_file_gives(system: SystemModel) -> None:
    assert ports_of(system, "/two") == {"/two/chat", "/plan", "/right", "/clocked"}


@pytest.mark.slow
def test_a_list_without_plugins(system: SystemModel) -> None:
    assert ports_of(system, "/three") == {"/three/chat", "/plan", "/clocked"}


@pytest.mark.slow
def test_what_plugins_return_decides(system: SystemModel) -> None:
    assert ports_of(system, "/four") == {"/four/chat", "/plan", "/a/left"}


def test_nodes_within_nodes(system: SystemModel) -> None:
    own = ["/arm/one", "/four", "/three", "/two"]
    assert sorted(node.name for node in system.nodes) == sorted(["/arm/grid/grid", *["/grid/grid"] * 3, *own])
    assert ports_of(system, "/arm/grid/grid") == {"/arm/grid/cells"}
    (with_file,) = (node for node in system.nodes if any(port.name == "/grid/squares" for port in node.ports))
    assert with_file.name == "/grid/grid"


def test_nodes_tell_their_component(system: SystemModel) -> None:
    assert {component_of(node.component or "") for node in system.nodes} == {"host/host"}
    assert len({node.component for node in system.nodes}) == 8


def test_each_instance_of_a_plugin_is_told_its_own_name() -> None:
    told = [PluginArgument("B", "C", ("B::set", 0, text)) for text in ("x", "y")] + [PluginArgument("B", "C", ("B::start", 1, "z"))]
    assert arguments_of_plugin("C", told) == [(("B::set", 0, "x"), ("B::start", 1, "z")), (("B::set", 0, "y"), ("B::start", 1, "z"))]
    assert arguments_of_plugin("other", told) == [()]


ROS1_MANIFEST = """<package format="2"><name>cam</name><version>1.0.0</version><description>d</description>
<maintainer email="a@b.c">m</maintainer><license>MIT</license><buildtool_depend>catkin</buildtool_depend>
<depend>roscpp</depend><depend>std_msgs</depend><depend>dynamic_reconfigure</depend></package>
"""
ROS1_CMAKE = """cmake_minimum_required(VERSION 3.0)
project(cam)
find_package(catkin REQUIRED COMPONENTS roscpp std_msgs dynamic_reconfigure)
generate_dynamic_reconfigure_options(cfg/Cam.cfg)
add_executable(cam src/cam.cpp)
"""
CONFIG = """#!/usr/bin/env python
from dynamic_reconfigure.parameter_generator_catkin import *
gen = ParameterGenerator()
gen.add("loud", bool_t, 0, "Say it", False)
exit(gen.generate("cam", "cam", "Cam"))
"""
CAM = """#include <cam/CamConfig.h>
#include <dynamic_reconfigure/server.h>
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_msgs/Empty.h>
bool loud = false;
bool raw = true;
ros::Publisher pub;
void onConfig(cam::CamConfig& config, uint32_t) { loud = config.loud; }
void onTick(const std_msgs::Empty&) {
  if (loud)
    pub.publish(std_msgs::Bool());
}
int main(int argc, char** argv) {
  ros::init(argc, argv, "cam");
  ros::NodeHandle nh, own("~");
  own.param("loud", loud, false);
  own.param("raw", raw, true);
  dynamic_reconfigure::Server<cam::CamConfig> server;
  server.setCallback(onConfig);
  pub = nh.advertise<std_msgs::Bool>("said", 1);
  ros::Subscriber tick = nh.subscribe("tick", 1, onTick), extra;
  if (raw)
    extra = nh.subscribe("raw", 1, onTick);
  ros::spin();
}
"""
CAMS = """<launch>
<node pkg="cam" type="cam" name="one"/>
<node pkg="cam" type="cam" name="two"><param name="raw" value="false"/></node>
</launch>
"""


@pytest.mark.slow
def test_what_may_be_reconfigured_is_not_decided(tmp_path: Path) -> None:
    for name, text in {
        "package.xml": ROS1_MANIFEST, "CMakeLists.txt": ROS1_CMAKE, "cfg/Cam.cfg": CONFIG, "src/cam.cpp": CAM, "main.launch": CAMS,
    }.items():  # fmt: skip
        (tmp_path / "cam" / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "cam" / name).write_text(text)
    where = LaunchEnvironment(tmp_path, (tmp_path,), {})
    analysis = analyze_systems(tmp_path, given([parse_request("cam/main.launch")], where), Method(sources=Settings(jobs=1)))
    (system,) = analysis.systems
    assert [name for name in ("/one", "/two") if "/raw" in ports_of(system, name)] == ["/one"]
    for title in (node.component for node in system.nodes):
        (model,) = (model for model in analysis.models if model.title == title)
        sent = {(reaction.input, reaction.output) for reaction in model.behavior.reactive}
        names = {port.id: port.name for port in model.ports}
        assert ("tick", "said") in {(names[one], names[other]) for one, other in sent}


SOURCES_MANIFEST = MANIFEST.replace("<name>host</name>", "<name>grid</name>").replace("<depend>pluginlib</depend>", "")
SOURCES_CMAKE = """cmake_minimum_required(VERSION 3.8)
project(grid)
find_package(ament_cmake REQUIRED)
find_package(rclcpp REQUIRED)
add_executable(grid src/grid.cpp)
ament_target_dependencies(grid rclcpp std_msgs)
install(TARGETS grid DESTINATION lib/${PROJECT_NAME})
ament_package()
"""
GRID = """#include <sstream>
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/bool.hpp"
#include "std_msgs/msg/string.hpp"
class Grid : public rclcpp::Node {
public:
  Grid() : rclcpp::Node("grid") {
    mask_ = declare_parameter("mask", std::string("mask"));
    std::stringstream words(declare_parameter("sources", std::string("")));
    std::string source;
    while (words >> source) {
      std::string topic;
      topic = declare_parameter(source + ".topic", source);
      topic = joined(topic);
      const std::string kind = declare_parameter(source + ".kind", std::string("bool"));
      if (kind == "bool") {
        listen(topic);
      } else {
        texts_.push_back(create_subscription<std_msgs::msg::String>(topic, 1, [](std_msgs::msg::String::SharedPtr) {}));
      }
    }
    start(mask_);
    state_ = create_publisher<std_msgs::msg::String>(below(get_namespace(), "state"), 1);
  }
  void start(const std::string & mask) {
    mask_ = joined(mask);
    listen(mask_);
  }
  void listen(const std::string & topic) {
    subs_.push_back(create_subscription<std_msgs::msg::Bool>(topic, 1, [](std_msgs::msg::Bool::SharedPtr) {}));
  }
  std::string joined(const std::string & topic) {
    if (topic[0] != '/') {
      std::string own = get_namespace();
      return own.substr(0, own.rfind("/")) + "/" + topic;
    }
    return topic;
  }
  static std::string below(const std::string & space, const std::string & name) {
    if (!space.empty() && space.back() == '/')
      return space + name;
    return space + "/" + name;
  }
private:
  std::string mask_;
  std::vector<rclcpp::Subscription<std_msgs::msg::Bool>::SharedPtr> subs_;
  std::vector<rclcpp::Subscription<std_msgs::msg::String>::SharedPtr> texts_;
  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr state_;
};
int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Grid>());
}
"""
GRIDS = """from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='grid', executable='grid', namespace='cart/local', parameters=[
            {'sources': 'scan cloud', 'scan.topic': 'laser/scan', 'cloud.kind': 'text', 'mask': 'zones'}]),
        Node(package='grid', executable='grid', parameters=[{'sources': 'map'}]),
    ])
"""


@pytest.mark.slow
def test_texts_are_followed_through_what_they_decide(tmp_path: Path) -> None:
    files = {"package.xml": SOURCES_MANIFEST, "CMakeLists.txt": SOURCES_CMAKE, "src/grid.cpp": GRID, "main.launch.py": GRIDS}
    for name, text in files.items():
        (tmp_path / "grid" / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "grid" / name).write_text(text)
    where = LaunchEnvironment(tmp_path, (tmp_path,), {})
    (system,) = analyze_systems(tmp_path, given([parse_request("grid/main.launch.py")], where), Method(sources=Settings(jobs=1))).systems
    assert ports_of(system, "/cart/local/grid") == {"/cart/laser/scan", "/cart/cloud", "/cart/zones", "/cart/local/state"}
    assert ports_of(system, "/grid") == {"/map", "/mask", "/state"}
    (node,) = (node for node in system.nodes if node.name == "/cart/local/grid")
    types = {(port.name, port.type) for port in node.ports if port.name in ("/cart/laser/scan", "/cart/cloud")}
    assert types == {("/cart/laser/scan", "std_msgs/Bool"), ("/cart/cloud", "std_msgs/String")}


ECHO = """#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
class Echo : public rclcpp::Node {
public:
  Echo() : rclcpp::Node("echo") {
    prefix_ = declare_parameter<std::string>("prefix", "");
    out_ = create_publisher<std_msgs::msg::String>("out", 1);
    in_ = create_subscription<std_msgs::msg::String>("in", 1, [this](std_msgs::msg::String::SharedPtr m) {
      if (prefix_.empty()) return;
      out_->publish(*m);
    });
  }
private:
  std::string prefix_;
  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr out_;
  rclcpp::Subscription<std_msgs::msg::String>::SharedPtr in_;
};
int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Echo>());
}
"""
ECHOES = """from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='grid', executable='grid', name='loud', parameters=[{'prefix': 'x'}]),
        Node(package='grid', executable='grid', name='quiet'),
        Node(package='grid', executable='grid', name='mute', parameters=[{'prefix': ''}]),
    ])
"""


FILLED = ECHO.replace(
    'prefix_ = declare_parameter<std::string>("prefix", "");',
    'declare_parameter<std::string>("prefix", ""); get_parameter("prefix", prefix_);',
)
FILLED = FILLED.replace("if (prefix_", "if (!prefix_")
ANEW = ECHO.replace("if (prefix_", 'get_parameter("prefix", prefix_);\n      if (prefix_')


@pytest.mark.slow
@pytest.mark.parametrize(
    ("source", "expected"),
    [
        (ECHO, {"/loud": [True], "/quiet": [], "/mute": []}),
        (FILLED, {"/loud": [], "/quiet": [True], "/mute": [True]}),
        (ANEW, {"/loud": [False], "/quiet": [False], "/mute": [False]}),
    ],
)
def test_a_text_decides_what_a_callback_does_unless_it_is_read_anew(tmp_path: Path, source: str, expected: dict[str, list[bool]]) -> None:
    files = {"package.xml": SOURCES_MANIFEST, "CMakeLists.txt": SOURCES_CMAKE, "src/grid.cpp": source, "main.launch.py": ECHOES}
    for name, text in files.items():
        (tmp_path / "grid" / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "grid" / name).write_text(text)
    where = LaunchEnvironment(tmp_path, (tmp_path,), {})
    analysis = analyze_systems(tmp_path, given([parse_request("grid/main.launch.py")], where), Method(sources=Settings(jobs=1)))
    models = {model.title: model for model in analysis.models}
    found = {node.name: [reaction.must for reaction in models[node.component].behavior.reactive] for node in analysis.systems[0].nodes}
    assert found == expected
