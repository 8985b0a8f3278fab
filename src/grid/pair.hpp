// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tether {

/// An x and a y component that the processor handles as one: the width every x86-64 has. Componentwise + - * with
/// pairs and with plain numbers.
using Pair = double __attribute__((vector_size(16)));

inline Pair pair(double x, double y) { return Pair{x, y}; }

}  // namespace tether
