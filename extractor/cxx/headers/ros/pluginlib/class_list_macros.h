// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <pluginlib/class_loader.h>
// An export leaves two typedefs in an anonymous namespace, named after __COUNTER__:
//   rosarch_plugin_class_N names the exported class, rosarch_plugin_base_N its base. Their TYPE_REFs are the facts.
#define ROSARCH_PLUGIN_JOIN_(a, b) a##b
#define ROSARCH_PLUGIN_JOIN(a, b) ROSARCH_PLUGIN_JOIN_(a, b)
#define ROSARCH_PLUGIN_N(n, class_type, base_class_type) \
  namespace { \
  typedef class_type ROSARCH_PLUGIN_JOIN(rosarch_plugin_class_, n); \
  typedef base_class_type ROSARCH_PLUGIN_JOIN(rosarch_plugin_base_, n); \
  }
#define PLUGINLIB_EXPORT_CLASS(class_type, base_class_type) ROSARCH_PLUGIN_N(__COUNTER__, class_type, base_class_type)
#define PLUGINLIB_EXPORT_CLASS_WITH_MESSAGE(class_type, base_class_type, message) PLUGINLIB_EXPORT_CLASS(class_type, base_class_type)
#define PLUGINLIB_DECLARE_CLASS(pkg, class_name, class_type, base_class_type) PLUGINLIB_EXPORT_CLASS(class_type, base_class_type)
#define PLUGINLIB_REGISTER_CLASS(class_name, class_type, base_class_type) PLUGINLIB_EXPORT_CLASS(class_type, base_class_type)
#define CLASS_LOADER_REGISTER_CLASS(class_type, base_class_type) PLUGINLIB_EXPORT_CLASS(class_type, base_class_type)
#define NODELET_DECLARE_CLASS(pkg, class_name, class_type, base_class_type) PLUGINLIB_EXPORT_CLASS(class_type, base_class_type)
