// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <ros/message_traits.h>
namespace ros {
class SerializedMessage { public: boost::shared_ptr<uint8_t> buf; size_t num_bytes; uint8_t* message_start; };
namespace serialization {
class StreamOverrunException {};
template <class T, class = void> struct Serializer { template <class S> static void write(S&, const T&);
  template <class S> static void read(S&, T&); static uint32_t serializedLength(const T&); };
struct Stream { uint8_t* getData(); uint32_t getLength(); uint8_t* advance(uint32_t); template <class T> void next(T&&);
  template <class T> Stream& operator<<(const T&); template <class T> Stream& operator>>(T&&); };
struct IStream : Stream { IStream(uint8_t*, uint32_t); };
struct OStream : Stream { OStream(uint8_t*, uint32_t); };
struct LStream : Stream { LStream(); };
template <class T, class S> void serialize(S&, const T&); template <class T, class S> void deserialize(S&, T&);
template <class T> uint32_t serializationLength(const T&); template <class M> SerializedMessage serializeMessage(const M&);
  template <class M> void deserializeMessage(const SerializedMessage&, M&);
}
}
