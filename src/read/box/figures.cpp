// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/box/figures.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <vector>

#include "base/numbers.hpp"

namespace tether {

void FigureReader::error(AnyVariable name, Subscript at, const std::string& message, const std::string& hint) {
  diagnostics_.add(deck_.remark(Severity::error, name, at, message, hint));
}

std::map<int, AnyVariable> FigureReader::given(const char* what, const Variables& names) {
  std::map<int, AnyVariable> given;
  for (const AnyVariable name : names) {
    for (const Subscript at : deck_.given_elements(name)) {
      const int k = name.row().rank == 1 ? at[0] : at[1];
      const auto [known, is_new] = given.emplace(k, name);
      if (is_new || known->second == name) continue;
      error(name, at, fmt::format("{} {} is given twice: by {} and by {}", what, k, known->second.name(), name.name()),
            "each has a number of its own");
      break;
    }
  }
  return given;
}

/// The first number that the deck gives of figure k.
Subscript FigureReader::first_given(RealVariable name, int k) const {
  const std::vector<Subscript> all = deck_.given_elements(name);
  return *std::find_if(all.begin(), all.end(), [k](const Subscript& at) { return at[1] == k; });
}

/// How many numbers the deck gives of figure k.
int FigureReader::count(RealVariable name, int k) const {
  int count = 0;
  for (const Subscript at : deck_.given_elements(name)) count += at[1] == k ? 1 : 0;
  return count;
}

std::optional<Box<3>> FigureReader::box(RealVariable name, int k) {
  Box<3> box;
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t a = at(axis);
    box.low[a] = grid_.low[a], box.high[a] = grid_.high(axis);
    if (axis >= grid_.dim) continue;
    const int first = 2 * axis + 1;
    for (const int end : {first, first + 1}) {
      if (deck_.given(name, end, k)) continue;
      error(name, {deck_.given(name, first, k) ? first : 1, k},
            fmt::format("{} {}: {}({},{}) is not given", name, k, name, end, k),
            "a box has a lowest and a highest place along each axis");
      return std::nullopt;
    }
    box.low[a] = deck_.real(name, first, k), box.high[a] = deck_.real(name, first + 1, k);
    if (!(box.high[a] > box.low[a])) {
      error(name, {first + 1, k}, fmt::format("{} {}: {:.6g} is not above {:.6g}", name, k, box.high[a], box.low[a]),
            "the lowest place first, along x, y, z");
      return std::nullopt;
    }
    if (box.high[a] > grid_.low[a] && box.low[a] < grid_.high(axis)) continue;
    error(name, {first, k},
          fmt::format("{} {} from {:.6g} to {:.6g} lies outside the box, {:.6g} to {:.6g} in {}", name, k, box.low[a],
                      box.high[a], grid_.low[a], grid_.high(axis), "xyz"[a]),
          "what reaches beyond the box is left away, but a part must lie in it");
    return std::nullopt;
  }
  return box;
}

std::optional<Figure> FigureReader::ellipse(RealVariable name, int k) {
  const auto about = box(name, k);
  if (!about) return std::nullopt;
  Ellipsoid ellipsoid;
  for (std::size_t a = 0; a < at(grid_.dim); ++a) {
    ellipsoid.middle[a] = 0.5 * (about->low[a] + about->high[a]);
    ellipsoid.half[a] = 0.5 * (about->high[a] - about->low[a]);
  }
  return ellipsoid;
}

std::optional<Figure> FigureReader::polygon(RealVariable name, int k) {
  Prism prism;
  const int numbers = count(name, k);
  for (int i = 1; i < numbers; i += 2) {
    if (deck_.given(name, i, k) && deck_.given(name, i + 1, k))
      prism.base.x.push_back(deck_.real(name, i, k)), prism.base.y.push_back(deck_.real(name, i + 1, k));
  }
  const Subscript first = first_given(name, k);
  if (numbers < 6 || numbers % 2 != 0 || 2 * prism.base.x.size() != at(numbers)) {
    error(name, first, fmt::format("{} {} has {} numbers, which are no corners of a polygon", name, k, numbers),
          fmt::format("it takes x and y of three corners or more, one after the other from {}(1,{}) on", name, k));
    return std::nullopt;
  }
  if (const auto edges = prism.base.crossing()) {
    error(name, first,
          fmt::format("{} {} goes through itself: edges {} and {} cross", name, k, edges->first + 1, edges->second + 1),
          "give its corners in turn");
    return std::nullopt;
  }
  return prism;
}

std::optional<Figure> FigureReader::plane(RealVariable name, int k) {
  const int dim = grid_.dim;
  HalfSpace half;
  const Subscript first = first_given(name, k);
  for (int i = 1; i <= 2 * dim; ++i) {
    if (deck_.given(name, i, k)) continue;
    error(name, first, fmt::format("{} {}: {}({},{}) is not given", name, k, name, i, k),
          "a place on it, then the direction from there into the fluid");
    return std::nullopt;
  }
  if (count(name, k) > 2 * dim) {
    error(name, first, fmt::format("{} {} has more than {} numbers", name, k, 2 * dim),
          "in the plane it takes x and y of a place on it and of the direction from there into the fluid");
    return std::nullopt;
  }
  for (int a = 0; a < dim; ++a)
    half.place[at(a)] = deck_.real(name, a + 1, k), half.normal[at(a)] = deck_.real(name, dim + a + 1, k);
  const double length = std::sqrt(dot(half.normal, half.normal));
  if (!is_positive(length)) {
    error(name, first, fmt::format("{} {} has a direction of no length", name, k), "it points into the fluid");
    return std::nullopt;
  }
  for (double& n : half.normal) n /= length;
  return half;
}

}  // namespace tether
