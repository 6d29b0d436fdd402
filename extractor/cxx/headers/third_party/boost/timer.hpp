// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
namespace boost { class timer { public: void restart(); double elapsed() const; }; class progress_timer : public timer {};
  class progress_display { public: explicit progress_display(unsigned long); unsigned long operator++();
  unsigned long operator+=(unsigned long); };
namespace timer_ns { class cpu_timer { public: void start(); void stop(); }; } }
