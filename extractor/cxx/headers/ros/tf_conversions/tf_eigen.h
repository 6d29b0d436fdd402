// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <tf/transform_datatypes.h>
#include <Eigen/Geometry>
namespace tf {
template <class A, class B> void matrixTFToEigen(const A&, B&); template <class A, class B> void matrixEigenToTF(const A&, B&);
  template <class A, class B> void poseTFToEigen(const A&, B&); template <class A, class B> void poseEigenToTF(const A&, B&);
template <class A, class B> void quaternionTFToEigen(const A&, B&); template <class A, class B> void quaternionEigenToTF(const A&, B&);
  template <class A, class B> void transformTFToEigen(const A&, B&); template <class A, class B> void transformEigenToTF(const A&, B&);
  template <class A, class B> void vectorTFToEigen(const A&, B&); template <class A, class B> void vectorEigenToTF(const A&, B&);
template <class A, class B> void poseMsgToEigen(const A&, B&); template <class A, class B> void poseEigenToMsg(const A&, B&);
  template <class A, class B> void pointMsgToEigen(const A&, B&); template <class A, class B> void pointEigenToMsg(const A&, B&);
  template <class A, class B> void quaternionMsgToEigen(const A&, B&); template <class A, class B> void quaternionEigenToMsg(const A&, B&);
template <class A, class B> void transformMsgToEigen(const A&, B&); template <class A, class B> void transformEigenToMsg(const A&, B&);
  template <class A, class B> void twistMsgToEigen(const A&, B&); template <class A, class B> void twistEigenToMsg(const A&, B&);
  template <class A, class B> void vectorMsgToEigen(const A&, B&); template <class A, class B> void vectorEigenToMsg(const A&, B&);
  template <class A, class B> void wrenchMsgToEigen(const A&, B&); template <class A, class B> void wrenchEigenToMsg(const A&, B&);
  template <class A, class B> void matrixEigenToMsg(const A&, B&);
}
