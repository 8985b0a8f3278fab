// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "physics/box/mesh/outline.hpp"

namespace tether::coupled {

/// Tetrahedra that fill what an outline encloses, without its holes: the outline's places and more, in this order.
struct Tetrahedra {
  std::vector<Vec<3>> x;
  std::vector<int> nodes;  ///< four of each

  std::size_t count() const { return nodes.size() / 4; }
};

/// Makes them with points in between, and leaves the outline's facets whole, by TetGen (H. Si, ACM Trans. Math. Softw.
/// 41 (2015) 11). It does so in a process of its own: TetGen spoils the memory where it fails. Throws RunError with the
/// place where facets cross or touch, and where TetGen fails.
Tetrahedra tetrahedra_in(const Outline& outline, std::span<const Vec<3>> points);

/// Throws RunError: there is no mesh about a place, and why.
[[noreturn]] void refuse_mesh(const Vec<3>& x, const std::string& why);

}  // namespace tether::coupled
