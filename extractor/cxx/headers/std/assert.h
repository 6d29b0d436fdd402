// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
// The expression is kept, whatever NDEBUG says: it is part of what the code states.
#undef assert
#define assert(expression) ((void)(expression))
