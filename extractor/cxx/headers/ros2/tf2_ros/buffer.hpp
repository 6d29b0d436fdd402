// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <tf2/buffer_core.hpp>
#include <message_filters/subscriber.hpp>
#include <rclcpp_lifecycle/lifecycle_node.hpp>
#include <tf2_msgs/msg/tf_message.hpp>
#include <tf2_msgs/action/lookup_transform.hpp>
#include <rclcpp_action/rclcpp_action.hpp>
namespace tf2_ros {
class DynamicListenerQoS : public rclcpp::QoS { public: explicit DynamicListenerQoS(size_t depth = 100); }; class StaticListenerQoS : public rclcpp::QoS { public: explicit StaticListenerQoS(size_t depth = 100); };
class DynamicBroadcasterQoS : public rclcpp::QoS { public: explicit DynamicBroadcasterQoS(size_t depth = 100); }; class StaticBroadcasterQoS : public rclcpp::QoS { public: explicit StaticBroadcasterQoS(size_t depth = 1); };
typedef uint64_t TransformRequestHandle; typedef std::shared_future<geometry_msgs::msg::TransformStamped> TransformStampedFuture; typedef std::function<void(const TransformStampedFuture&)> TransformReadyCallback;
rclcpp::Time toRclcpp(const tf2::TimePoint&); tf2::TimePoint fromRclcpp(const rclcpp::Time&); rclcpp::Duration toRclcpp(const tf2::Duration&); tf2::Duration fromRclcpp(const rclcpp::Duration&);
builtin_interfaces::msg::Time toMsg(const tf2::TimePoint&); tf2::TimePoint fromMsg(const builtin_interfaces::msg::Time&); builtin_interfaces::msg::Duration toMsg(const tf2::Duration&);
tf2::Duration fromMsg(const builtin_interfaces::msg::Duration&); double timeToSec(const builtin_interfaces::msg::Time&);
class CreateTimerInterface { public: RCLCPP_POINTERS(CreateTimerInterface) virtual ~CreateTimerInterface(); };
class CreateTimerROS : public CreateTimerInterface { public: template <class... A> CreateTimerROS(const A&...); };
class AsyncBufferInterface { public: virtual ~AsyncBufferInterface(); };
class BufferInterface { public: RCLCPP_POINTERS(BufferInterface) virtual ~BufferInterface();
  template <class A, class B, class C, class... X> geometry_msgs::msg::TransformStamped lookupTransform(const A&, const B&, const C&, const X&...) const;
  template <class A, class B, class C, class... X> bool canTransform(const A&, const B&, const C&, const X&...) const;
  template <class T, class F> T transform(const T&, const F&, tf2::Duration = tf2::Duration(0)) const;
  template <class A, class B, class F, class... X> B& transform(const A&, B&, const F&, const X&...) const;
};
class Buffer : public BufferInterface, public AsyncBufferInterface, public tf2::BufferCore {
public:
  RCLCPP_POINTERS(Buffer)
  template <class C, class... A> Buffer(const C& clock, const A&... cache_time_and_node);
  using BufferInterface::lookupTransform; using BufferInterface::canTransform;
  template <class... A> TransformStampedFuture waitForTransform(const A&...); void cancel(const TransformStampedFuture&); void setCreateTimerInterface(CreateTimerInterface::SharedPtr);
  rclcpp::Clock::SharedPtr get_clock() const;
};
class BufferClient : public BufferInterface { public: template <class N, class Ns, class... A> BufferClient(const N& node, const Ns& ns, const A&...); bool waitForServer(const tf2::Duration& = tf2::Duration(0)); };
class BufferServer { public: template <class B, class N, class Ns, class... A> BufferServer(const B& buffer, const N& node, const Ns& ns, const A&...); };
class TransformListener { public: RCLCPP_POINTERS(TransformListener) template <class B, class... A> explicit TransformListener(B& buffer, A&&... node_spin_thread_qos_options); virtual ~TransformListener();
protected: virtual void subscription_callback(tf2_msgs::msg::TFMessage::ConstSharedPtr msg, bool is_static); rclcpp::Node::SharedPtr optional_default_node_; tf2::BufferCore& buffer_; };
class StaticTransformListener : public TransformListener { public: template <class B, class... A> explicit StaticTransformListener(B& buffer, A&&...); };
class TransformBroadcaster { public: RCLCPP_POINTERS(TransformBroadcaster) template <class N, class... A> explicit TransformBroadcaster(N&& node, const A&...); template <class T> void sendTransform(const T& transform); };
class StaticTransformBroadcaster { public: RCLCPP_POINTERS(StaticTransformBroadcaster) template <class N, class... A> explicit StaticTransformBroadcaster(N&& node, const A&...); template <class T> void sendTransform(const T& transform); };
namespace filter_failure_reasons { enum FilterFailureReason { Unknown, OutTheBack, EmptyFrameID, NoTransformFound, QueueFull }; }
typedef filter_failure_reasons::FilterFailureReason FilterFailureReason;
class MessageFilterBase { public: virtual ~MessageFilterBase(); virtual void clear(); virtual void setTargetFrame(const std::string&); virtual void setTargetFrames(const std::vector<std::string>&);
  template <class T> void setTolerance(const T&); };
template <class M, class B = Buffer> class MessageFilter : public MessageFilterBase, public message_filters::SimpleFilter<M> { public: RCLCPP_POINTERS(MessageFilter)
  template <class... A> MessageFilter(A&&...); template <class F> void connectInput(F&); void setQueueSize(uint32_t); std::string getTargetFramesString(); template <class X> void add(const X&);
  template <class... A> message_filters::Connection registerFailureCallback(const A&...); };
}
