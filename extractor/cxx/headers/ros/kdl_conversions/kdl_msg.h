// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <kdl/frames.hpp>
namespace tf { 
#define ROSARCH_KDL(name) template <class A, class B> void name##MsgToKDL(const A&, B&); \
  template <class A, class B> void name##KDLToMsg(const A&, B&); template <class A, class B> void name##KDLToTF(const A&, B&); \
  template <class A, class B> void name##TFToKDL(const A&, B&);
ROSARCH_KDL(point) ROSARCH_KDL(pose) ROSARCH_KDL(quaternion) ROSARCH_KDL(transform) ROSARCH_KDL(twist) ROSARCH_KDL(vector)
  ROSARCH_KDL(wrench) ROSARCH_KDL(Pose) ROSARCH_KDL(Transform)
#undef ROSARCH_KDL
}
