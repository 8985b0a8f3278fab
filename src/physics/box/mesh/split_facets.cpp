// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/mesh/split_facets.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <utility>

namespace tether::coupled {
namespace {

using Edge = std::pair<std::size_t, std::size_t>;  // places, the lower first
using Middles = std::map<Edge, std::size_t>;
using Corners = std::array<std::size_t, 3>;

Edge edge_of(const Corners& corners, std::size_t k) { return std::minmax(corners[k], corners[(k + 1) % 3]); }

double square_of(const Outline& outline, const Edge& edge) {
  const Vec<3> way = minus(outline.places[edge.second], outline.places[edge.first]);
  return dot(way, way);
}

/// The middles of edges that are longer than `size`.
Middles middles_of(std::size_t first, double size, Outline& outline) {
  Middles middles;
  for (std::size_t f = first; f < outline.facets.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Edge edge = edge_of(outline.facets[f].corners, k);
      if (square_of(outline, edge) <= size * size) continue;
      const auto [of, is_new] = middles.try_emplace(edge, outline.places.size());
      if (!is_new) continue;
      const Vec<3>&a = outline.places[edge.first], &b = outline.places[edge.second];
      outline.places.push_back({0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2])});
    }
  }
  return middles;
}

/// Calls f(corners) for the parts of a triangle whose edges are halved: two where it is one of them, and four where it
/// is all. Where it is two, a corner is cut off, and what is left is cut along the shorter way across.
template <class Function>
void each_part(Corners corners, const Outline& outline, const Middles& middles, const Function& f) {
  constexpr std::size_t whole = std::numeric_limits<std::size_t>::max();
  std::array<std::size_t, 3> middle{};  // of the edge from each corner on
  for (std::size_t k = 0; k < 3; ++k) {
    const auto of = middles.find(edge_of(corners, k));
    middle[k] = of == middles.end() ? whole : of->second;
  }
  const auto halved = 3 - std::ranges::count(middle, whole);
  if (halved == 0) return f(corners);
  const auto turn = [&] {
    std::ranges::rotate(corners, corners.begin() + 1), std::ranges::rotate(middle, middle.begin() + 1);
  };
  while (halved < 3 && (middle[0] == whole) != (halved == 2)) turn();
  const auto [a, b, c] = corners;
  const auto [ab, bc, ca] = middle;
  if (halved == 1) return f({a, ab, c}), f({ab, b, c});
  f({bc, c, ca});
  if (halved == 3) return f({a, ab, ca}), f({ab, b, bc}), f({ab, bc, ca});
  if (square_of(outline, {a, bc}) < square_of(outline, {b, ca})) return f({a, b, bc}), f({a, bc, ca});
  f({a, b, ca}), f({b, bc, ca});
}

}  // namespace

void split_facets(std::size_t first, double size, Outline& outline) {
  while (true) {
    const Middles middles = middles_of(first, size, outline);
    if (middles.empty()) return;
    const std::vector<Outline::Facet> before(outline.facets.begin() + static_cast<std::ptrdiff_t>(first),
                                             outline.facets.end());
    outline.facets.resize(first);
    for (const Outline::Facet& facet : before) {
      each_part(facet.corners, outline, middles, [&](const Corners& corners) {
        outline.facets.push_back(facet), outline.facets.back().corners = corners;
      });
    }
  }
}

}  // namespace tether::coupled
