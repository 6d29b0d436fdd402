"""Plug-ins of ROS 1 in lists of maps, and ports that a host makes only for plug-ins of a class."""

from __future__ import annotations

from pathlib import Path

import pytest

from rosarch.analysis.method import Method
from rosarch.analysis.systems.analysis import analyze_systems
from rosarch.analysis.systems.launches import given
from rosarch.analysis.systems.requests import LaunchEnvironment, parse_request
from rosarch.extractor.settings import Settings

MANIFEST = """<package format="2"><name>layers</name><version>1.0.0</version><description>d</description>
<maintainer email="a@example.com">m</maintainer><license>MIT</license><buildtool_depend>catkin</buildtool_depend>
<depend>roscpp</depend><depend>std_msgs</depend><depend>pluginlib</depend>
<export><layers plugin="${prefix}/plugins.xml"/></export></package>
"""
CMAKE = """cmake_minimum_required(VERSION 3.0)
project(layers)
find_package(catkin REQUIRED COMPONENTS roscpp std_msgs pluginlib)
add_library(own src/own.cpp)
add_executable(host src/host.cpp)
"""
PLUGINS = """<library path="lib/libown">
<class name="layers/Left" type="layers::Left" base_class_type="layers::Layer"/>
<class name="layers/Right" type="layers::Right" base_class_type="layers::Layer"/>
</library>
"""
HEADER = """#pragma once
#include <ros/ros.h>
#include <string>
namespace layers {
class Layer {
public:
  virtual ~Layer() {}
  virtual void initialize(const std::string& name) = 0;
  std::string name() const { return name_; }
protected:
  std::string name_;
};
class Grid : public Layer {};
}
"""
OWN = """#include "layer.h"
#include <pluginlib/class_list_macros.h>
#include <std_msgs/Bool.h>
namespace layers {
class Left : public Layer {
public:
  void initialize(const std::string& name) override {
    name_ = name;
    ros::NodeHandle own("~/" + name_);
    pub_ = own.advertise<std_msgs::Bool>("left", 1);
  }
private:
  ros::Publisher pub_;
};
class Right : public Grid {
public:
  void initialize(const std::string& name) override {
    name_ = name;
    ros::NodeHandle own("~/" + name_);
    pub_ = own.advertise<std_msgs::Bool>("right", 1);
  }
private:
  ros::Publisher pub_;
};
}
PLUGINLIB_EXPORT_CLASS(layers::Left, layers::Layer)
PLUGINLIB_EXPORT_CLASS(layers::Right, layers::Layer)
"""
HOST = """#include "layer.h"
#include <pluginlib/class_loader.h>
#include <std_msgs/Bool.h>
class Shown {
public:
  Shown(ros::NodeHandle& nh, const std::string& name) { pub_ = nh.advertise<std_msgs::Bool>(name + "_shown", 1); }
private:
  ros::Publisher pub_;
};
int main(int argc, char** argv) {
  ros::init(argc, argv, "host");
  ros::NodeHandle nh, own("~/grid");
  pluginlib::ClassLoader<layers::Layer> loader("layers", "layers::Layer");
  std::vector<boost::shared_ptr<layers::Layer>> made;
  std::vector<boost::shared_ptr<Shown>> shown;
  XmlRpc::XmlRpcValue list;
  own.getParam("plugins", list);
  for (int32_t i = 0; i < list.size(); ++i) {
    std::string name = static_cast<std::string>(list[i]["name"]);
    std::string type = static_cast<std::string>(list[i]["type"]);
    boost::shared_ptr<layers::Layer> layer = loader.createInstance(type);
    layer->initialize(name);
    made.push_back(layer);
    boost::shared_ptr<layers::Grid> grid = boost::dynamic_pointer_cast<layers::Grid>(layer);
    if (grid) {
      shown.push_back(boost::make_shared<Shown>(nh, name));
    }
  }
  ros::spin();
}
"""
LAUNCH = """<launch><node pkg="layers" type="host" name="host"><rosparam>
grid:
  plugins:
    - {name: one, type: "layers/Left"}
    - {name: two, type: "layers/Right"}
    - {name: three, type: "layers/Left"}
</rosparam></node></launch>
"""


@pytest.mark.slow
def test_each_map_of_a_list_is_a_plugin(tmp_path: Path) -> None:
    files = {
        "package.xml": MANIFEST, "CMakeLists.txt": CMAKE, "plugins.xml": PLUGINS, "src/layer.h": HEADER, "src/own.cpp": OWN, "src/host.cpp": HOST,
        "main.launch": LAUNCH,
    }  # fmt: skip
    for name, text in files.items():
        path = tmp_path / "layers" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    where = LaunchEnvironment(tmp_path, (tmp_path,), {})
    (system,) = analyze_systems(tmp_path, given([parse_request("layers/main.launch")], where), Method(sources=Settings(jobs=1))).systems
    (node,) = (node for node in system.nodes if node.name == "/host")
    assert {port.name for port in node.ports if not port.implicit} == {
        "/host/one/left",
        "/host/two/right",
        "/host/three/left",
        "/two_shown",
    }
