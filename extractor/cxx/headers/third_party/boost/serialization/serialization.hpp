// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
// Archives take everything with & and << and >>.
#include <string>
namespace boost {
namespace serialization {
class access; template <class A, class T> void split_free(A&, T&, unsigned);
  template <class A, class T> void split_member(A&, T&, unsigned); template <class B, class D> B& base_object(D&);
  template <class T> T& make_nvp(const char*, T&); template <class T> T& make_array(T*, std::size_t); template <class T> struct version {};
}
namespace archive {
#define ROSARCH_ARCHIVE(Name) class Name { public: template <class S> explicit Name(S&, int = 0); template <class T> Name& operator<<(T&&); \
  template <class T> Name& operator>>(T&&); template <class T> Name& operator&(T&&); template <class T> void register_type(T* = nullptr); };
ROSARCH_ARCHIVE(binary_iarchive) ROSARCH_ARCHIVE(binary_oarchive) ROSARCH_ARCHIVE(text_iarchive) ROSARCH_ARCHIVE(text_oarchive)
  ROSARCH_ARCHIVE(xml_iarchive) ROSARCH_ARCHIVE(xml_oarchive)
#undef ROSARCH_ARCHIVE
}
}
#define BOOST_SERIALIZATION_SPLIT_FREE(T)
#define BOOST_SERIALIZATION_SPLIT_MEMBER()
#define BOOST_SERIALIZATION_NVP(x) x
#define BOOST_SERIALIZATION_BASE_OBJECT_NVP(T) ::boost::serialization::base_object<T>(*this)
#define BOOST_SERIALIZATION_ASSUME_ABSTRACT(T)
#define BOOST_CLASS_EXPORT(T)
#define BOOST_CLASS_EXPORT_KEY(T)
#define BOOST_CLASS_EXPORT_IMPLEMENT(T)
#define BOOST_CLASS_VERSION(T, n)
