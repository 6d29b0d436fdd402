// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
// A range-for: the loop and its body stay in the tree.
#define BOOST_FOREACH(variable, ...) for (variable : __VA_ARGS__)
#define BOOST_REVERSE_FOREACH(variable, ...) for (variable : __VA_ARGS__)
