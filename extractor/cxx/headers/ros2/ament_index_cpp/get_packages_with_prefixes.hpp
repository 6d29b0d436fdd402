// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <ament_index_cpp/get_package_share_directory.hpp>
