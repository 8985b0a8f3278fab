// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>

#include "grid/shapes.hpp"

namespace tether {

/// The place in element e that s in its reference element stands for.
inline Vec<2> place_in(const Mesh& mesh, int e, const Vec<2>& s) {
  return with_shapes(mesh.kind, [&](auto shapes) {
    Vec<2> x{};
    if constexpr (decltype(shapes)::dim == 2) {
      const auto N = decltype(shapes)::values(s);
      for (std::size_t a = 0; a < N.size(); ++a) {
        const auto at = 2 * static_cast<std::size_t>(mesh.element(static_cast<std::size_t>(e))[a]);
        x[0] += N[a] * mesh.x[at], x[1] += N[a] * mesh.x[at + 1];
      }
    }
    return x;
  });
}

inline double distance(const Vec<2>& a, const Vec<2>& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

}  // namespace tether
