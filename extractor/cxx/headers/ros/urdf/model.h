// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <map>
#include <string>
#include <vector>
#include <boost/shared_ptr.hpp>
#include <ros/node_handle.h>
class TiXmlElement; class TiXmlDocument;
namespace urdf {
struct Vector3 { double x, y, z; void clear(); }; struct Rotation { double x, y, z, w; void getRPY(double&, double&, double&) const; };
  struct Pose { Vector3 position; Rotation rotation; }; struct Color { float r, g, b, a; };
struct Geometry { enum { SPHERE, BOX, CYLINDER, MESH } type; }; struct Box : Geometry { Vector3 dim; };
  struct Sphere : Geometry { double radius; }; struct Cylinder : Geometry { double length, radius; };
  struct Mesh : Geometry { std::string filename; Vector3 scale; };
typedef boost::shared_ptr<Geometry> GeometrySharedPtr; struct Visual { Pose origin; GeometrySharedPtr geometry; std::string material_name;
  }; struct Collision { Pose origin; GeometrySharedPtr geometry; }; typedef boost::shared_ptr<Collision> CollisionSharedPtr;
  typedef boost::shared_ptr<Visual> VisualSharedPtr;
struct Inertial { Pose origin; double mass, ixx, ixy, ixz, iyy, iyz, izz; };
struct JointLimits { double lower, upper, effort, velocity; };
  struct JointSafety { double soft_upper_limit, soft_lower_limit, k_position, k_velocity; };
  struct JointDynamics { double damping, friction; }; struct JointCalibration { boost::shared_ptr<double> rising, falling; };
  struct JointMimic { double offset, multiplier; std::string joint_name; };
struct Joint { std::string name; enum { UNKNOWN, REVOLUTE, CONTINUOUS, PRISMATIC, FLOATING, PLANAR, FIXED } type; Vector3 axis;
  std::string child_link_name, parent_link_name; Pose parent_to_joint_origin_transform; boost::shared_ptr<JointLimits> limits;
  boost::shared_ptr<JointSafety> safety; boost::shared_ptr<JointDynamics> dynamics; boost::shared_ptr<JointCalibration> calibration;
  boost::shared_ptr<JointMimic> mimic; };
typedef boost::shared_ptr<Joint> JointSharedPtr; typedef boost::shared_ptr<const Joint> JointConstSharedPtr;
struct Link { std::string name; boost::shared_ptr<Inertial> inertial; boost::shared_ptr<Visual> visual;
  boost::shared_ptr<Collision> collision; std::vector<CollisionSharedPtr> collision_array; boost::shared_ptr<Joint> parent_joint;
  std::vector<boost::shared_ptr<Joint>> child_joints; std::vector<boost::shared_ptr<Link>> child_links;
  boost::shared_ptr<Link> getParent() const; };
typedef boost::shared_ptr<Link> LinkSharedPtr; typedef boost::shared_ptr<const Link> LinkConstSharedPtr;
class ModelInterface { public: std::string name_; std::map<std::string, boost::shared_ptr<Link>> links_;
  std::map<std::string, boost::shared_ptr<Joint>> joints_; const std::string& getName() const;
  boost::shared_ptr<const Link> getRoot() const; boost::shared_ptr<const Link> getLink(const std::string&) const;
  boost::shared_ptr<const Joint> getJoint(const std::string&) const; void getLinks(std::vector<boost::shared_ptr<Link>>&) const; };
typedef boost::shared_ptr<ModelInterface> ModelInterfaceSharedPtr;
  typedef boost::shared_ptr<const ModelInterface> ModelInterfaceConstSharedPtr;
class Model : public ModelInterface { public: bool initFile(const std::string&); bool initParam(const std::string&);
  bool initParamWithNodeHandle(const std::string&, const ros::NodeHandle& = ros::NodeHandle()); bool initString(const std::string&); };
ModelInterfaceSharedPtr parseURDF(const std::string&);
}
