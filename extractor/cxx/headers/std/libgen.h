// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
extern "C" { char* dirname(char*); char* basename(char*); }
