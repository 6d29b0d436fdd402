// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <sensor_msgs/PointCloud2.h>
namespace sensor_msgs {
class PointCloud2Modifier { public: explicit PointCloud2Modifier(PointCloud2&); size_t size() const; void reserve(size_t);
  void resize(size_t); void clear(); void setPointCloud2Fields(int, ...); void setPointCloud2FieldsByString(int, ...); };
template <class T> class PointCloud2Iterator { public: PointCloud2Iterator(PointCloud2&, const std::string&); T& operator[](size_t) const;
  T& operator*() const; PointCloud2Iterator& operator++(); PointCloud2Iterator operator+(int) const; PointCloud2Iterator& operator+=(int);
  bool operator!=(const PointCloud2Iterator&) const; bool operator==(const PointCloud2Iterator&) const; PointCloud2Iterator end() const; };
template <class T> class PointCloud2ConstIterator { public: PointCloud2ConstIterator(const PointCloud2&, const std::string&);
  const T& operator[](size_t) const; const T& operator*() const; PointCloud2ConstIterator& operator++();
  PointCloud2ConstIterator operator+(int) const; PointCloud2ConstIterator& operator+=(int);
  bool operator!=(const PointCloud2ConstIterator&) const; bool operator==(const PointCloud2ConstIterator&) const;
  PointCloud2ConstIterator end() const; };
}
