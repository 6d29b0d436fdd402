// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <ros/ros.h>
#include <boost/thread/recursive_mutex.hpp>
namespace dynamic_reconfigure {
template <class Config> class Server {
public:
  typedef boost::function<void(Config&, uint32_t level)> CallbackType;
  Server(const ros::NodeHandle& = ros::NodeHandle("~"));
  Server(boost::recursive_mutex&, const ros::NodeHandle& = ros::NodeHandle("~"));
  template <class F> void setCallback(const F& callback); void clearCallback();
  template <class C> void updateConfig(const C&); void setConfigDefault(const Config&); void setConfigMin(const Config&);
    void setConfigMax(const Config&); void getConfigDefault(Config&); void getConfigMin(Config&); void getConfigMax(Config&);
};
template <class Config> class Client { public: template <class... A> Client(const std::string&, const A&...);
  template <class F> void setConfigurationCallback(const F&); bool setConfiguration(const Config&);
  bool getCurrentConfiguration(Config&, const ros::Duration& = ros::Duration(0));
  bool getDefaultConfiguration(Config&, const ros::Duration& = ros::Duration(0)); };
}
