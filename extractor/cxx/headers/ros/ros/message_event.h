// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <ros/message_traits.h>
namespace ros {
template <class M> class MessageEvent {
public:
  typedef typename std::add_const<M>::type ConstMessage;
  typedef typename std::remove_const<M>::type Message;
  typedef boost::shared_ptr<Message> MessagePtr;
  typedef boost::shared_ptr<ConstMessage> ConstMessagePtr;
  MessageEvent();
  MessageEvent(const ConstMessagePtr&);
  template <class N> MessageEvent(const MessageEvent<N>&);
  template <class... A> MessageEvent(const ConstMessagePtr&, const A&...);
  MessageEvent& operator=(const MessageEvent&);
  boost::shared_ptr<M> getMessage() const;
  const ConstMessagePtr& getConstMessage() const;
  M_string& getConnectionHeader() const;
  const boost::shared_ptr<M_string>& getConnectionHeaderPtr() const;
  const std::string& getPublisherName() const;
  Time getReceiptTime() const;
  operator ConstMessagePtr() const;
};
}
