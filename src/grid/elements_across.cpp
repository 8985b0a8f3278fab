// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/elements_across.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>

#include "grid/ways_across.hpp"

namespace tether {
namespace {

/// Part of the boundary that may be thinner than what counts as the thickness: where a body tapers.
constexpr double thin_part = 0.1;

/// Ways whose layers of triangles or tetrahedra are counted edge by edge, at most.
constexpr std::size_t counted_ways = 64;

double area_of(const std::vector<Way>& ways) {
  double area = 0;
  for (const Way& way : ways) area += way.area;
  return area;
}

/// Those across the thin direction: of the ways that leave opposite the shortest, from a tenth of their boundary. Of a
/// body that has next to none, a wedge, all.
std::vector<Way> thin_ways(const std::vector<Way>& ways) {
  std::vector<Way> thin;
  std::ranges::copy_if(ways, std::back_inserter(thin), &Way::opposed);
  const double whole = area_of(thin);
  if (whole < thin_part * area_of(ways)) return ways;
  std::ranges::sort(thin, {}, &Way::length);
  double area = 0;
  std::size_t count = 0;
  while (count < thin.size() && area < thin_part * whole) area += thin[count++].area;
  thin.resize(count);
  return thin;
}

/// As many of them, evenly.
std::vector<Way> some_of(const std::vector<Way>& ways, std::size_t most) {
  if (ways.size() <= most) return ways;
  std::vector<Way> some;
  for (std::size_t k = 0; k < most; ++k) some.push_back(ways[k * ways.size() / most]);
  return some;
}

double mean_layers(const Mesh& mesh, const std::vector<Way>& ways) {
  double sum = 0;
  if (!is_simplex(mesh.kind)) {
    for (const Way& way : ways) sum += way.area * way.layers;
    return std::round(sum / area_of(ways));
  }
  const std::vector<Way> some = some_of(ways, counted_ways);
  const std::vector<double> layers = layers_across(mesh, some);
  for (std::size_t k = 0; k < some.size(); ++k) sum += some[k].area * layers[k];
  return std::max(1.0, std::round(sum / area_of(some)));
}

ElementsAcross thin_direction(const Mesh& mesh, const std::vector<Way>& all) {
  const std::vector<Way> ways = thin_ways(all);
  ElementsAcross across;
  for (const Way& way : ways) across.thickness += way.area * way.length;
  across.thickness /= area_of(ways);
  across.count = mean_layers(mesh, ways);
  return across;
}

/// What is left is the mean element: its volume and its extent across give its length.
void measure_elements(const Mesh& mesh, const std::vector<std::size_t>& elements, ElementsAcross& across) {
  const auto dim = static_cast<std::size_t>(mesh.dim());
  std::array<double, 3> low, high;
  low.fill(std::numeric_limits<double>::infinity()), high.fill(-std::numeric_limits<double>::infinity());
  double volume = 0;
  std::set<int> regions;
  for (const std::size_t e : elements) {
    volume += volume_of_element(mesh, e);
    regions.insert(mesh.region[e]);
    for (int a = 0; a < node_count_of(mesh.kind); ++a) {
      for (std::size_t i = 0; i < dim; ++i) {
        const double x = mesh.x[static_cast<std::size_t>(mesh.element(e)[a]) * dim + i];
        low[i] = std::min(low[i], x), high[i] = std::max(high[i], x);
      }
    }
  }
  for (std::size_t i = 0; i < dim; ++i) across.longest = std::max(across.longest, high[i] - low[i]);
  const double per_cell = !is_simplex(mesh.kind) ? 1 : dim == 2 ? 2 : 6;
  const double cell = per_cell * volume / static_cast<double>(elements.size());
  across.along = std::pow(cell * across.count / across.thickness, 1 / (static_cast<double>(dim) - 1));
  across.regions.assign(regions.begin(), regions.end());
}

}  // namespace

std::vector<ElementsAcross> elements_across(const Mesh& mesh) {
  if (order_of(mesh.kind) != 1 || mesh.element_count() == 0) return {};
  const std::vector<int> part = parts_of(mesh);
  const auto part_of = [&](std::size_t e) {
    return static_cast<std::size_t>(part[static_cast<std::size_t>(mesh.element(e)[0])]);
  };
  std::vector<std::vector<Way>> ways(static_cast<std::size_t>(count_parts(mesh)));
  std::vector<std::vector<std::size_t>> elements(ways.size());
  for (std::size_t e = 0; e < mesh.element_count(); ++e) elements[part_of(e)].push_back(e);
  for (const Way& way : ways_across(mesh)) ways[part_of(way.element)].push_back(way);
  std::vector<ElementsAcross> all;
  for (std::size_t p = 0; p < ways.size(); ++p) {
    all.push_back(thin_direction(mesh, ways[p]));
    measure_elements(mesh, elements[p], all.back());
  }
  return all;
}

}  // namespace tether
