// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
namespace boost { class noncopyable { protected: noncopyable() {} ~noncopyable() {} }; }
