// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
namespace message_filters { struct NullType {}; template <class M> struct NullFilter {}; }
