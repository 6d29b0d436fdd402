// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <ros/message_event.h>
#include <boost/function.hpp>
#include <boost/foreach.hpp>
#include <stdexcept>
namespace rosbag {
class BagException : public std::runtime_error { public: BagException(const std::string&); }; typedef BagException BagIOException;
  typedef BagException BagFormatException; typedef BagException BagUnindexedException;
namespace bagmode { enum BagMode { Write = 1, Read = 2, Append = 4 }; } typedef bagmode::BagMode BagMode;
enum CompressionType { Uncompressed }; namespace compression { enum CompressionType { Uncompressed, BZ2, LZ4 }; }
struct ConnectionInfo { uint32_t id; std::string topic; std::string datatype; std::string md5sum; std::string msg_def;
  boost::shared_ptr<ros::M_string> header; };
class MessageInstance { public: const ros::Time& getTime() const; const std::string& getTopic() const;
  const std::string& getDataType() const; const std::string& getMD5Sum() const; const std::string& getMessageDefinition() const;
  std::string getCallerId() const; bool isLatching() const; uint32_t size() const; template <class M> bool isType() const;
  template <class M> boost::shared_ptr<M> instantiate() const; };
class Bag { public: Bag(); explicit Bag(const std::string&, uint32_t = bagmode::Read); ~Bag();
  void open(const std::string& file, uint32_t mode = bagmode::Read); void close(); std::string getFileName() const;
  uint64_t getSize() const; bool isOpen() const; template <class... A> void write(const std::string& topic, const A&...);
  void setCompression(compression::CompressionType); void setChunkThreshold(uint32_t); };
struct TopicQuery { TopicQuery(const std::string&); TopicQuery(const std::vector<std::string>&); };
  struct TypeQuery { TypeQuery(const std::string&); TypeQuery(const std::vector<std::string>&); };
class View { public: typedef MessageInstance* iterator; typedef MessageInstance* const_iterator; typedef MessageInstance value_type;
  explicit View(bool = false); template <class... A> explicit View(const Bag&, const A&...); iterator begin(); iterator end();
  uint32_t size(); template <class... A> void addQuery(const Bag&, const A&...); std::vector<const ConnectionInfo*> getConnections();
  ros::Time getBeginTime(); ros::Time getEndTime(); };
struct PlayerOptions { std::string prefix; bool quiet, start_paused, at_once, bag_time, loop, keep_alive;
  double bag_time_frequency, time_scale; int queue_size; ros::WallDuration advertise_sleep; std::vector<std::string> bags;
  std::vector<std::string> topics; bool try_future; bool has_time; double time; void check(); };
class Player { public: Player(const PlayerOptions&); void publish(); };
struct RecorderOptions { bool record_all, regex, quiet, append_date, snapshot, verbose; std::string prefix, name;
  std::vector<std::string> topics; }; class Recorder { public: Recorder(const RecorderOptions&); int run(); void doTrigger(); };
}
