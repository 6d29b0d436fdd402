// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <boost/thread/mutex.hpp>
#include <boost/bind.hpp>
#include <boost/shared_ptr.hpp>
#include <pthread.h>
#include <unistd.h>
#include <boost/date_time/posix_time/posix_time.hpp>
#include <boost/chrono.hpp>
namespace boost {
enum class cv_status { no_timeout, timeout };
class condition_variable {
public:
  void notify_one(); void notify_all();
  template <class L> void wait(L&); template <class L, class P> void wait(L&, P);
  template <class L, class T> bool timed_wait(L&, const T&); template <class L, class T, class P> bool timed_wait(L&, const T&, P);
  template <class L, class T> cv_status wait_for(L&, const T&); template <class L, class T, class P> bool wait_for(L&, const T&, P);
    template <class L, class T> cv_status wait_until(L&, const T&);
};
typedef condition_variable condition_variable_any; typedef condition_variable condition;
class thread_interrupted {};
class thread_resource_error {};
class thread {
public:
  class id {}; class attributes { public: void set_stack_size(std::size_t); }; typedef unsigned long native_handle_type;
  thread(); thread(thread&&); template <class F, class... A, class = typename std::enable_if<!std::is_same<typename std::decay<F>::type,
    thread>::value>::type> explicit thread(const F&, const A&...); ~thread(); thread& operator=(thread&&);
  bool joinable() const; void join(); template <class D> bool timed_join(const D&); template <class D> bool try_join_for(const D&);
    void detach(); void interrupt(); bool interruption_requested() const;
  id get_id() const; native_handle_type native_handle(); void swap(thread&); static unsigned hardware_concurrency(); static void yield();
    template <class T> static void sleep(const T&);
};
bool operator==(const thread::id&, const thread::id&); bool operator!=(const thread::id&, const thread::id&);
  bool operator<(const thread::id&, const thread::id&);
class thread_group { public: template <class F> thread* create_thread(const F&); void add_thread(thread*); void remove_thread(thread*);
  void join_all(); void interrupt_all(); int size() const; };
template <class T> class thread_specific_ptr { public: T* get() const; T* operator->() const; T& operator*() const; T* release();
  void reset(T* = nullptr); };
class barrier { public: explicit barrier(unsigned); bool wait(); };
struct once_flag {};
#define BOOST_ONCE_INIT {}
template <class F, class... A> void call_once(once_flag&, const F&, const A&...);
namespace this_thread {
thread::id get_id(); void yield(); void interruption_point(); bool interruption_enabled(); bool interruption_requested();
template <class D> void sleep(const D&); template <class D> void sleep_for(const D&); template <class T> void sleep_until(const T&);
class disable_interruption {};
}
}
