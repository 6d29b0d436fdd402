// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <ros/message_prelude.h>
namespace ros {
namespace message_traits {
struct TrueType { static const bool value = true; };
struct FalseType { static const bool value = false; };
template <class M, class = void> struct MD5Sum { static const char* value(); static const char* value(const M&); };
template <class M, class = void> struct DataType { static const char* value(); static const char* value(const M&); };
template <class M, class = void> struct Definition { static const char* value(); static const char* value(const M&); };
template <class M, class = void> struct HasHeader : TrueType {};
template <class M, class = void> struct IsFixedSize : FalseType {};
template <class M, class = void> struct IsSimple : FalseType {};
template <class M, class = void> struct IsMessage : TrueType {};
template <class M, class = void> struct TimeStamp { static ros::Time* pointer(M&); static ros::Time value(const M&); };
template <class M, class = void> struct FrameId { static std::string* pointer(M&); static std::string value(const M&); };
template <class M> const char* md5sum(); template <class M> const char* md5sum(const M&);
template <class M> const char* datatype(); template <class M> const char* datatype(const M&);
template <class M> const char* definition(); template <class M> const char* definition(const M&);
template <class M> bool hasHeader(); template <class M> bool isFixedSize(); template <class M> bool isSimple();
}
namespace message_operations { template <class M, class = void> struct Printer { template <class S> static void stream(S&,
  const std::string&, const M&); }; }
template <class M, class = void> struct ParameterAdapter { typedef M Message; };
struct VoidConst {};
typedef boost::shared_ptr<void> VoidPtr;
typedef boost::shared_ptr<const void> VoidConstPtr;
typedef boost::weak_ptr<const void> VoidConstWPtr;
}
