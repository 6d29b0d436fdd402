#include <ros/ros.h>
#include "../../../../etc/passwd"
# include "node.cpp" // again
/* #include "no.h" */
const char* text = R"(#include "raw.h")";
#if __has_include(<x.h>)
#include MACRO
#endif
PLUGINLIB_EXPORT_CLASS(here::Plugin, nodelet::Nodelet)
PLUGINLIB_DECLARE_CLASS(here, Name, here::Other, base::Class) // "
PLUGINLIB_REGISTER_CLASS(Name, here::Other,
  base::Class<int>)
