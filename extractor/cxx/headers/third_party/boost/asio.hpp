// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <boost/bind.hpp>
#include <boost/noncopyable.hpp>
#include <boost/system/error_code.hpp>
#include <boost/date_time/posix_time/posix_time.hpp>
#include <boost/shared_ptr.hpp>
#include <vector>
#include <istream>
#include <chrono>
// Buffers, sockets, ports and timers with the members node code uses; arguments are not checked.
namespace boost { namespace asio {
using boost::system::error_code;
class io_service {
public:
  class work { public: explicit work(io_service&); };
  class strand { public: explicit strand(io_service&); template <class F> F wrap(const F&); template <class F> void post(const F&);
    template <class F> void dispatch(const F&); };
  io_service(); explicit io_service(int); std::size_t run(); template <class E> std::size_t run(E&); std::size_t run_one();
    std::size_t poll(); std::size_t poll_one(); void stop(); void reset(); void restart(); bool stopped() const;
  template <class F> void post(const F&); template <class F> void dispatch(const F&); template <class F> F wrap(const F&);
    template <class E> void notify_fork(E);
};
typedef io_service io_context; typedef io_service::strand strand;
class mutable_buffer { public: mutable_buffer(); mutable_buffer(void*, std::size_t); std::size_t size() const; void* data() const; };
typedef mutable_buffer const_buffer; typedef mutable_buffer mutable_buffers_1; typedef mutable_buffer const_buffers_1;
template <class... A> mutable_buffer buffer(const A&...);
template <class T, class B> T buffer_cast(const B&); template <class B> std::size_t buffer_size(const B&);
class streambuf : public std::streambuf { public: explicit streambuf(std::size_t = 0); std::size_t size() const; void consume(std::size_t);
  void commit(std::size_t); mutable_buffer data() const; mutable_buffer prepare(std::size_t); };
template <class... A> std::size_t read(A&&...); template <class... A> std::size_t write(A&&...);
  template <class... A> std::size_t read_until(A&&...); template <class... A> std::size_t read_at(A&&...);
template <class... A> void async_read(A&&...); template <class... A> void async_write(A&&...);
  template <class... A> void async_read_until(A&&...); template <class... A> void async_connect(A&&...);
  template <class... A> void connect(A&&...);
#define ROSARCH_IO(Self) \
  template <class... A> explicit Self(A&&...); \
  template <class... A> void open(A&&...); template <class... A> void close(A&&...); template <class... A> void cancel(A&&...); \
    bool is_open() const; template <class... A> void assign(A&&...); \
  template <class... A> std::size_t send(A&&...); template <class... A> std::size_t send_to(A&&...); \
    template <class... A> std::size_t receive(A&&...); template <class... A> std::size_t receive_from(A&&...); \
  template <class... A> std::size_t read_some(A&&...); template <class... A> std::size_t write_some(A&&...); \
    template <class... A> void async_read_some(A&&...); template <class... A> void async_write_some(A&&...); \
  template <class... A> void async_send(A&&...); template <class... A> void async_send_to(A&&...); \
    template <class... A> void async_receive(A&&...); template <class... A> void async_receive_from(A&&...); \
  template <class... A> void connect(A&&...); template <class... A> void async_connect(A&&...); template <class... A> void bind(A&&...); \
    template <class... A> void set_option(A&&...); template <class... A> void get_option(A&&...) const; \
  template <class... A> void io_control(A&&...); template <class... A> void shutdown(A&&...); \
    template <class... A> void non_blocking(A&&...); template <class... A> void send_break(A&&...); std::size_t available() const; \
    int native_handle(); int native(); io_service& get_io_service(); io_service& get_executor();
namespace ip {
class address { public: address(); std::string to_string() const; static address from_string(const std::string&); bool is_v4() const;
  bool is_v6() const; bool is_multicast() const; bool operator==(const address&) const; bool operator!=(const address&) const; };
class address_v4 : public address { public: address_v4(); explicit address_v4(unsigned long); static address_v4 any();
  static address_v4 broadcast(); static address_v4 loopback(); static address_v4 from_string(const std::string&);
  unsigned long to_ulong() const; };
typedef address_v4 address_v6;
address make_address(const std::string&);
template <class Protocol> class endpoint { public: endpoint(); template <class A> endpoint(const A&, unsigned short);
  ip::address address() const; void address(const ip::address&); unsigned short port() const; void port(unsigned short);
  Protocol protocol() const; bool operator==(const endpoint&) const; bool operator!=(const endpoint&) const; };
template <class Protocol> class resolver {
public:
  struct query { template <class... A> query(A&&...); };
  struct iterator { iterator(); const endpoint<Protocol>& operator*() const; endpoint<Protocol>* operator->() const;
    operator endpoint<Protocol>() const; iterator& operator++(); iterator operator++(int); bool operator==(const iterator&) const;
    bool operator!=(const iterator&) const; };
  explicit resolver(io_service&); template <class... A> iterator resolve(A&&...); template <class... A> void async_resolve(A&&...);
    void cancel();
};
template <class Protocol> class socket { public: ROSARCH_IO(socket) endpoint<Protocol> local_endpoint() const;
  endpoint<Protocol> remote_endpoint() const; 
  enum shutdown_type { shutdown_receive, shutdown_send, shutdown_both }; struct reuse_address { reuse_address(bool = true); };
    struct broadcast { broadcast(bool = true); }; struct receive_buffer_size { receive_buffer_size(int); };
    struct send_buffer_size { send_buffer_size(int); }; struct keep_alive { keep_alive(bool = true); };
    typedef endpoint<Protocol> endpoint_type; };
class udp { public: typedef ip::endpoint<udp> endpoint; typedef ip::resolver<udp> resolver; typedef ip::socket<udp> socket; static udp v4();
  static udp v6(); };
class tcp { public: typedef ip::endpoint<tcp> endpoint; typedef ip::resolver<tcp> resolver; typedef ip::socket<tcp> socket;
  struct no_delay { no_delay(bool = true); }; typedef std::iostream iostream; static tcp v4(); static tcp v6();
  class acceptor { public: template <class... A> explicit acceptor(A&&...); template <class... A> void accept(A&&...);
    template <class... A> void async_accept(A&&...); template <class... A> void open(A&&...); template <class... A> void bind(A&&...);
    void listen(int = 0); void close(); void cancel(); template <class... A> void set_option(A&&...);
    struct reuse_address { reuse_address(bool = true); }; }; };
namespace multicast { struct join_group { template <class... A> join_group(A&&...); };
  struct leave_group { template <class... A> leave_group(A&&...); }; struct hops { hops(int); };
  struct enable_loopback { enable_loopback(bool); }; struct outbound_interface { template <class... A> outbound_interface(A&&...); }; }
}
class serial_port_base {
public:
  struct baud_rate { explicit baud_rate(unsigned = 0); unsigned value() const; };
    struct character_size { explicit character_size(unsigned = 8); };
  struct flow_control { enum type { none, software, hardware }; explicit flow_control(type = none); };
    struct parity { enum type { none, odd, even }; explicit parity(type = none); }; struct stop_bits { enum type { one, onepointfive, two };
    explicit stop_bits(type = one); };
};
class serial_port : public serial_port_base { public: ROSARCH_IO(serial_port) };
#undef ROSARCH_IO
template <class Time> class basic_timer { public: template <class... A> explicit basic_timer(A&&...);
  template <class D> std::size_t expires_from_now(const D&); Time expires_from_now() const;
  template <class T> std::size_t expires_at(const T&); Time expires_at() const; template <class D> std::size_t expires_after(const D&);
  std::size_t cancel(); void wait(); template <class E> void wait(E&); template <class F> void async_wait(const F&); };
typedef basic_timer<posix_time::ptime> deadline_timer; typedef basic_timer<std::chrono::steady_clock::time_point> steady_timer;
class signal_set { public: template <class... A> explicit signal_set(A&&...); template <class F> void async_wait(const F&); void add(int);
  };
namespace error { enum basic_errors { operation_aborted = 125, eof = 2, connection_refused, connection_reset, timed_out, would_block,
  not_found, host_not_found }; class category {}; 
inline bool operator==(const error_code&, basic_errors) { return false; }
  inline bool operator!=(const error_code&, basic_errors) { return false; } }
namespace placeholders { extern const std::rosarch_placeholder<1> error; extern const std::rosarch_placeholder<2> bytes_transferred;
  extern const std::rosarch_placeholder<2> iterator; extern const std::rosarch_placeholder<2> signal_number; }
struct transfer_at_least { explicit transfer_at_least(std::size_t); }; struct transfer_exactly { explicit transfer_exactly(std::size_t); };
  struct transfer_all {};
} }
