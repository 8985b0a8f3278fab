// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

namespace tether {

inline double seconds_since(std::chrono::steady_clock::time_point from) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - from).count();
}

}  // namespace tether
