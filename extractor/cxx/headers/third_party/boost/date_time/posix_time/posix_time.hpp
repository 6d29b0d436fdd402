// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <cstdint>
#include <ctime>
namespace boost {
namespace gregorian {
class date { public: date(); date(int, int, int); int year() const; int month() const; int day() const; bool is_not_a_date() const;
  long day_number() const; bool operator==(const date&) const; bool operator<(const date&) const; long operator-(const date&) const; };
std::string to_iso_string(const date&); std::string to_iso_extended_string(const date&); std::string to_simple_string(const date&);
struct day_clock { static date local_day(); static date universal_day(); };
enum months_of_year { Jan = 1, Feb, Mar, Apr, May, Jun, Jul, Aug, Sep, Oct, Nov, Dec };
}
namespace date_time { enum special_values { not_a_date_time, neg_infin, pos_infin, min_date_time, max_date_time, not_special }; }
using namespace date_time;
namespace posix_time {
using namespace date_time;
class time_duration {
public:
  time_duration(); time_duration(special_values); time_duration(long, long, long, long = 0);
  long hours() const; long minutes() const; long seconds() const; long fractional_seconds() const; long total_seconds() const;
    long total_milliseconds() const; long total_microseconds() const; long total_nanoseconds() const; long ticks() const;
    static long ticks_per_second();
  bool is_negative() const; bool is_special() const; time_duration operator-() const; time_duration operator+(const time_duration&) const;
    time_duration operator-(const time_duration&) const; time_duration operator*(int) const; time_duration operator/(int) const;
  time_duration& operator+=(const time_duration&); time_duration& operator-=(const time_duration&);
  bool operator<(const time_duration&) const; bool operator>(const time_duration&) const; bool operator<=(const time_duration&) const;
    bool operator>=(const time_duration&) const; bool operator==(const time_duration&) const; bool operator!=(const time_duration&) const;
};
#define ROSARCH_DURATION(name) class name : public time_duration { public: template <class N> explicit name(const N&); };
ROSARCH_DURATION(hours) ROSARCH_DURATION(minutes) ROSARCH_DURATION(seconds) ROSARCH_DURATION(milliseconds) ROSARCH_DURATION(millisec)
  ROSARCH_DURATION(microseconds) ROSARCH_DURATION(microsec) ROSARCH_DURATION(nanoseconds)
#undef ROSARCH_DURATION
class ptime {
public:
  ptime(); ptime(special_values); ptime(const gregorian::date&); ptime(const gregorian::date&, const time_duration&);
  gregorian::date date() const; time_duration time_of_day() const; bool is_not_a_date_time() const; bool is_special() const;
  ptime operator+(const time_duration&) const; ptime operator-(const time_duration&) const; time_duration operator-(const ptime&) const;
    ptime& operator+=(const time_duration&);
  bool operator<(const ptime&) const; bool operator>(const ptime&) const; bool operator<=(const ptime&) const;
    bool operator>=(const ptime&) const; bool operator==(const ptime&) const; bool operator!=(const ptime&) const;
};
struct microsec_clock { static ptime local_time(); static ptime universal_time(); };
struct second_clock { static ptime local_time(); static ptime universal_time(); };
std::string to_iso_string(const ptime&); std::string to_iso_extended_string(const ptime&); std::string to_simple_string(const ptime&);
  std::string to_simple_string(const time_duration&);
ptime time_from_string(const std::string&); ptime from_time_t(std::time_t); ptime from_iso_string(const std::string&);
  std::tm to_tm(const ptime&); std::time_t to_time_t(const ptime&); time_duration duration_from_string(const std::string&);
class time_facet { public: template <class... A> explicit time_facet(A...); void format(const char*); };
class time_input_facet : public time_facet { public: using time_facet::time_facet; };
class time_period { public: time_period(const ptime&, const ptime&); bool contains(const ptime&) const; };
}
typedef posix_time::ptime system_time;
system_time get_system_time();
}
