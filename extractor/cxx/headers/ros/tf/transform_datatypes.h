// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <tf/LinearMath/Transform.h>
#include <ros/time.h>
#include <geometry_msgs/PointStamped.h>
#include <geometry_msgs/Vector3Stamped.h>
#include <geometry_msgs/QuaternionStamped.h>
#include <geometry_msgs/TransformStamped.h>
#include <geometry_msgs/PoseStamped.h>
namespace tf {
template <class T> class Stamped : public T {
public:
  ros::Time stamp_;
  std::string frame_id_;
  Stamped();
  Stamped(const T& input, const ros::Time& stamp, const std::string& frame_id);
  void setData(const T&);
  bool operator==(const Stamped&) const;
};
class StampedTransform : public Transform {
public:
  ros::Time stamp_;
  std::string frame_id_;
  std::string child_frame_id_;
  StampedTransform();
  StampedTransform(const Transform& input, const ros::Time& stamp, const std::string& frame_id, const std::string& child_frame_id);
  void setData(const Transform&);
  bool operator==(const StampedTransform&) const;
};
typedef Stamped<Point> StampedPoint;
double getYaw(const Quaternion&); double getYaw(const geometry_msgs::Quaternion&);
Quaternion createQuaternionFromYaw(double); Quaternion createQuaternionFromRPY(double, double, double);
  Quaternion createIdentityQuaternion();
geometry_msgs::Quaternion createQuaternionMsgFromYaw(double);
  geometry_msgs::Quaternion createQuaternionMsgFromRollPitchYaw(double, double, double);
#define ROSARCH_CONVERSION(Name, name, Msg) \
  void name##MsgToTF(const geometry_msgs::Msg&, Name&); \
  void name##TFToMsg(const Name&, geometry_msgs::Msg&); \
  void name##StampedMsgToTF(const geometry_msgs::Msg##Stamped&, Stamped<Name>&); \
  void name##StampedTFToMsg(const Stamped<Name>&, geometry_msgs::Msg##Stamped&);
ROSARCH_CONVERSION(Quaternion, quaternion, Quaternion) ROSARCH_CONVERSION(Vector3, vector3, Vector3) ROSARCH_CONVERSION(Point, point,
  Point) ROSARCH_CONVERSION(Pose, pose, Pose)
#undef ROSARCH_CONVERSION
void transformMsgToTF(const geometry_msgs::Transform&, Transform&); void transformTFToMsg(const Transform&, geometry_msgs::Transform&);
void transformStampedMsgToTF(const geometry_msgs::TransformStamped&, StampedTransform&);
  void transformStampedTFToMsg(const StampedTransform&, geometry_msgs::TransformStamped&);
void assertQuaternionValid(const Quaternion&); void assertQuaternionValid(const geometry_msgs::Quaternion&);
}
