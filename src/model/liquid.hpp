// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <variant>
#include <vector>

#include "base/expression.hpp"
#include "base/words.hpp"
#include "grid/figures.hpp"

namespace tether {

/// What air is to a liquid: nothing, whose pressure is zero; or, where nothing lets it out, a volume that stays.
enum class Air { empty, sealed };
template <>
inline constexpr std::array<Word<Air>, 2> words<Air>{{{Air::empty, "void"}, {Air::sealed, "sealed"}}};

/// All that lies below a height, a function of x and z [length].
struct Below {
  std::shared_ptr<const Expression> height;
};

/// All places at which an expression in x, y and z is not 0.
struct Where {
  std::shared_ptr<const Expression> holds;
};

/// A part of the box that holds liquid at the start.
struct LiquidRegion {
  std::variant<Figure, Below, Where> shape;
  Vec<3> velocity{};
  int number = 0;  ///< of the deck's region, from 1
};
/// Returns whether a region has a place, bodies and obstacles left aside.
bool contains(const LiquidRegion& region, const Vec<3>& x);

/// A liquid with a surface: it fills what its regions have of the box at the start, and what jets bring.
struct Liquid {
  std::vector<LiquidRegion> regions;
  Air air = Air::empty;
  double jitter = 0;  ///< how far particles stand off their lattice at the start, of their distance
  int per_axis = 2;   ///< particles along each axis of a cell that it fills
};

}  // namespace tether
