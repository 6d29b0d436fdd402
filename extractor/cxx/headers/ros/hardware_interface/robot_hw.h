// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <ros/ros.h>
#include <list>
#include <map>
namespace hardware_interface {
class HardwareInterfaceException : public std::exception { public: HardwareInterfaceException(const std::string&); };
struct InterfaceResources { std::string hardware_interface; std::set<std::string> resources; };
struct ControllerInfo { std::string name; std::string type; std::vector<InterfaceResources> claimed_resources; };
class HardwareInterface { public: virtual ~HardwareInterface(); virtual void claim(std::string); std::set<std::string> getClaims() const;
  void clearClaims(); };
class JointStateHandle { public: JointStateHandle(); template <class... A> JointStateHandle(const std::string& name, const A&...);
  std::string getName() const; double getPosition() const; double getVelocity() const; double getEffort() const; };
class JointHandle : public JointStateHandle { public: JointHandle(); JointHandle(const JointStateHandle&, double*); void setCommand(double);
  double getCommand() const; };
class ImuSensorHandle { public: struct Data { std::string name, frame_id;
  double *orientation, *orientation_covariance, *angular_velocity, *angular_velocity_covariance, *linear_acceleration,
  *linear_acceleration_covariance; }; ImuSensorHandle(); ImuSensorHandle(const Data&); std::string getName() const;
  std::string getFrameId() const; const double* getOrientation() const; const double* getAngularVelocity() const;
  const double* getLinearAcceleration() const; };
class ForceTorqueSensorHandle { public: template <class... A> ForceTorqueSensorHandle(const A&...); std::string getName() const;
  const double* getForce() const; const double* getTorque() const; };
template <class Handle> class HardwareResourceManager : public HardwareInterface { public: typedef Handle ResourceHandleType;
  void registerHandle(const Handle&); Handle getHandle(const std::string&); std::vector<std::string> getNames() const; };
class JointStateInterface : public HardwareResourceManager<JointStateHandle> {};
  class JointCommandInterface : public HardwareResourceManager<JointHandle> {};
class PositionJointInterface : public JointCommandInterface {}; class VelocityJointInterface : public JointCommandInterface {};
  class EffortJointInterface : public JointCommandInterface {};
  class ImuSensorInterface : public HardwareResourceManager<ImuSensorHandle> {};
  class ForceTorqueSensorInterface : public HardwareResourceManager<ForceTorqueSensorHandle> {};
class InterfaceManager { public: template <class T> void registerInterface(T*); template <class T> T* get();
  std::vector<std::string> getNames() const; void registerInterfaceManager(InterfaceManager*); };
class RobotHW : public InterfaceManager { public: RobotHW(); virtual ~RobotHW(); virtual bool init(ros::NodeHandle&, ros::NodeHandle&);
  virtual bool checkForConflict(const std::list<ControllerInfo>&) const;
  virtual bool prepareSwitch(const std::list<ControllerInfo>&, const std::list<ControllerInfo>&);
  virtual void doSwitch(const std::list<ControllerInfo>&, const std::list<ControllerInfo>&);
  virtual void read(const ros::Time&, const ros::Duration&); virtual void write(const ros::Time&, const ros::Duration&); };
}
