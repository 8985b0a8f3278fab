// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace tether {

/// An array's index of a number that counts cells, axes or nodes and is not negative.
constexpr std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace tether
