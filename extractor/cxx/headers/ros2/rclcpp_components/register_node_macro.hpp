// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <rclcpp/rclcpp.hpp>
// registering makes the class a component; the class is visible as a type
#define RCLCPP_COMPONENTS_REGISTER_NODE_AT(type, line) RCLCPP_COMPONENTS_REGISTER_NODE_NAMED(type, line)
#define RCLCPP_COMPONENTS_REGISTER_NODE_NAMED(type, line) typedef type rosarch_registered_##line;
#define RCLCPP_COMPONENTS_REGISTER_NODE(type) RCLCPP_COMPONENTS_REGISTER_NODE_AT(type, __LINE__)
namespace rclcpp_components {
class NodeInstanceWrapper { public: rclcpp::node_interfaces::NodeBaseInterface::SharedPtr get_node_base_interface(); std::shared_ptr<void> get_node_instance() const; };
class NodeFactory { public: virtual ~NodeFactory(); virtual NodeInstanceWrapper create_node_instance(const rclcpp::NodeOptions&) = 0; };
class ComponentManager : public rclcpp::Node { public: template <class... A> ComponentManager(const A&...); };
}
