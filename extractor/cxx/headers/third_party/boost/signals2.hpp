// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <boost/function.hpp>
#include <boost/shared_ptr.hpp>
// Qt calls a macro `signals`.
#pragma push_macro("signals")
#undef signals
namespace boost { namespace signals2 {
class connection { public: void disconnect() const; bool connected() const; bool blocked() const; };
class scoped_connection : public connection { public: scoped_connection(); scoped_connection(const connection&);
  scoped_connection& operator=(const connection&); };
template <class S> class signal;
template <class R, class... P> class signal<R(P...)> { public: typedef boost::function<R(P...)> slot_function_type;
  typedef boost::function<R(P...)> slot_type; template <class F, class... X> connection connect(const F&, const X&...);
  template <class F> void disconnect(const F&); void disconnect_all_slots(); R operator()(P...) const; bool empty() const;
  std::size_t num_slots() const; };
} 
template <class S> using signal = signals2::signal<S>;
namespace signals { using signals2::connection; } }
#pragma pop_macro("signals")
