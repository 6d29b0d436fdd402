// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <bits/utility.h>
#include <mutex>
namespace boost {
struct defer_lock_t {}; struct try_to_lock_t {}; struct adopt_lock_t {};
const defer_lock_t defer_lock = {}; const try_to_lock_t try_to_lock = {}; const adopt_lock_t adopt_lock = {};
template <class M> class unique_lock {
public:
  typedef M mutex_type;
  unique_lock(); explicit unique_lock(M&); template <class X> unique_lock(M&, const X&); unique_lock(unique_lock&&); ~unique_lock();
    unique_lock& operator=(unique_lock&&);
  void lock(); bool try_lock(); void unlock(); template <class D> bool timed_lock(const D&); template <class D> bool try_lock_for(const D&);
    bool owns_lock() const; explicit operator bool() const; bool operator!() const; M* mutex() const; M* release();
};
template <class M> class shared_lock {
public:
  shared_lock(); explicit shared_lock(M&); template <class X> shared_lock(M&, const X&); ~shared_lock();
  void lock(); bool try_lock(); void unlock(); bool owns_lock() const; explicit operator bool() const;
};
template <class M> class upgrade_lock : public shared_lock<M> { public: using shared_lock<M>::shared_lock; };
template <class M> class upgrade_to_unique_lock { public: explicit upgrade_to_unique_lock(upgrade_lock<M>&); ~upgrade_to_unique_lock(); };
template <class M> class lock_guard { public: explicit lock_guard(M&); lock_guard(M&, adopt_lock_t); ~lock_guard(); };
class mutex {
public:
  typedef unique_lock<mutex> scoped_lock; typedef unique_lock<mutex> scoped_try_lock;
  mutex(); ~mutex(); void lock(); bool try_lock(); void unlock();
};
class try_mutex : public mutex {};
class timed_mutex { public: typedef unique_lock<timed_mutex> scoped_lock; typedef unique_lock<timed_mutex> scoped_timed_lock; void lock();
  bool try_lock(); void unlock(); template <class D> bool timed_lock(const D&); };
class recursive_mutex { public: typedef unique_lock<recursive_mutex> scoped_lock; typedef unique_lock<recursive_mutex> scoped_try_lock;
  recursive_mutex(); void lock(); bool try_lock(); void unlock(); };
class recursive_timed_mutex : public recursive_mutex {};
class shared_mutex { public: typedef unique_lock<shared_mutex> scoped_lock; shared_mutex(); void lock(); bool try_lock(); void unlock();
  void lock_shared(); bool try_lock_shared(); void unlock_shared(); };
typedef shared_mutex upgrade_mutex;
template <class... M> void lock(M&...);
}
