// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace tether::mpm {

/// Slots of a body's points, the end excluded.
struct Range {
  std::size_t begin = 0, end = 0;
};

}  // namespace tether::mpm
