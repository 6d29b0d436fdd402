// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <stdint.h>
struct js_event { uint32_t time; int16_t value; uint8_t type; uint8_t number; };
#define JS_EVENT_BUTTON 1
#define JS_EVENT_AXIS 2
#define JS_EVENT_INIT 0x80
#define JSIOCGNAME(len) (len)
#define JSIOCGAXES 1
#define JSIOCGBUTTONS 2
