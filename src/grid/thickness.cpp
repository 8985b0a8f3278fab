// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/thickness.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "base/numbers.hpp"
#include "base/vec.hpp"
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

/// Measures the mean element, which is what is left: its volume and its extent across give its length.
void measure_elements(const Mesh& mesh, const std::vector<std::size_t>& elements, ElementsAcross& across) {
  const auto dim = static_cast<std::size_t>(mesh.dim());
  Vec<3> low, high;
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

/// How far the middle of an edge stands off the line between its ends, in the mean over the elements of their largest.
double mean_bulge(const Mesh& mesh, const std::vector<std::size_t>& elements) {
  const auto dim = static_cast<std::size_t>(mesh.dim());
  const std::vector<std::array<int, 3>> edges = curved_edges_of(mesh.kind);
  double sum = 0;
  for (const std::size_t e : elements) {
    double most = 0;
    for (const auto& [a, b, middle] : edges) {
      double square = 0;
      for (std::size_t i = 0; i < dim; ++i) {
        const auto x = [&](int node) { return mesh.x[static_cast<std::size_t>(mesh.element(e)[node]) * dim + i]; };
        square += std::pow(x(middle) - 0.5 * (x(a) + x(b)), 2);
      }
      most = std::max(most, square);
    }
    sum += std::sqrt(most);
  }
  return sum / static_cast<double>(elements.size());
}

/// How far edges that meet in a corner lean from the right angle, in the mean over the elements of their largest.
double mean_lean(const Mesh& mesh, const std::vector<std::size_t>& elements) {
  if (is_simplex(mesh.kind)) return 0;
  const int dim = mesh.dim();
  const auto edge = [&](std::size_t e, int from, int axis) {
    Vec<3> way{};
    for (int i = 0; i < dim; ++i)
      way[at(i)] =
          mesh.x[at(mesh.element(e)[from ^ 1 << axis] * dim + i)] - mesh.x[at(mesh.element(e)[from] * dim + i)];
    return way;
  };
  double sum = 0;
  for (const std::size_t e : elements) {
    double most = 0;
    for (int c = 0; c < corner_count_of(mesh.kind); ++c) {
      for (int axis = 0; axis < dim; ++axis) {
        const Vec<3> a = edge(e, c, axis), b = edge(e, c, (axis + 1) % dim);
        most = std::max(most, std::abs(dot(a, b)) / std::sqrt(dot(a, a) * dot(b, b)));
      }
    }
    sum += std::asin(std::min(most, 1.0));
  }
  return sum / static_cast<double>(elements.size());
}

}  // namespace

std::vector<ElementsAcross> elements_across(const Mesh& of) {
  if (of.element_count() == 0) return {};
  const Mesh mesh = by_corners(of);
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
    all.back().bulge = mean_bulge(of, elements[p]), all.back().lean = mean_lean(mesh, elements[p]);
  }
  return all;
}

namespace {

std::size_t edge_count(const Mesh& mesh) { return is_simplex(mesh.kind) ? 3 : 4; }

/// Returns the area of an element between its corners, whose nodes stand at x [length^2].
double area_of(const Mesh& mesh, std::span<const double> x, std::size_t e) {
  double area = 0;
  for (std::size_t k = 0; k < edge_count(mesh); ++k) {
    const auto [a, b] = ends_of_edge(mesh, e, k);
    area += 0.5 * (x[2 * a] * x[2 * b + 1] - x[2 * b] * x[2 * a + 1]);
  }
  return area;
}

/// Which edges of the elements belong to no other one.
std::vector<std::array<bool, 4>> edges_on_outline(const Mesh& mesh) {
  std::map<std::pair<std::size_t, std::size_t>, int> count;
  const auto ends = [&](std::size_t e, std::size_t k) {
    const auto [a, b] = ends_of_edge(mesh, e, k);
    return std::pair(std::min(a, b), std::max(a, b));
  };
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    for (std::size_t k = 0; k < edge_count(mesh); ++k) ++count[ends(e, k)];
  }
  std::vector<std::array<bool, 4>> alone(mesh.element_count());
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    for (std::size_t k = 0; k < edge_count(mesh); ++k) alone[e][k] = count[ends(e, k)] == 1;
  }
  return alone;
}

/// The shorter side of a rectangle; of an outline that no rectangle of the area has, a square's.
double thickness_of(double area, double outline) {
  const double half = 0.5 * outline, root = half * half - 4 * area;
  return root > 0 ? 2 * area / (half + std::sqrt(root)) : 0.5 * half;
}

}  // namespace

std::string thin_body_advice(int order_of_fluid) {
  if (order_of_fluid == 1)
    return "how far it bends may be wrong by a factor of three; two cells and more across it, or element='q2q1', "
           "bring it within a tenth";
  return "it may bend too far by a tenth to a third; one cell and more across it brings it within some percent";
}

BodyThickness::BodyThickness(const Mesh& below, const Mesh& bodies)
    : below_(below),
      bodies_(bodies),
      spacings_(below),
      on_outline_(edges_on_outline(bodies)),
      part_of_node_(parts_of(bodies)),
      element_below_(bodies.element_count(), -1),
      area_(at(count_parts(bodies))),
      outline_(area_.size()),
      region_(area_.size(), -1) {
  for (std::size_t e = 0; e < bodies.element_count(); ++e) {
    int& region = region_[at(part_of_node_[at(bodies.element(e)[0])])];
    if (region < 0) region = bodies.region[e];
  }
}

double BodyThickness::length_of_outline(std::size_t e, const std::array<NodeSpacing, 4>& spacing) const {
  const double in_cells = static_cast<double>(order_of(bodies_.kind)) / order_of(below_.kind);
  double length = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    if (on_outline_[e][k]) length += in_cells * spacing[k].ratio();
  }
  return length;
}

ThinBody BodyThickness::thinnest(std::span<const double> x) {
  std::ranges::fill(area_, 0.0), std::ranges::fill(outline_, 0.0);
  for (std::size_t e = 0; e < bodies_.element_count(); ++e) {
    const auto spacing = spacings_.of_element(bodies_, x, e, element_below_[e]);
    if (!spacing) continue;
    const std::size_t part = at(part_of_node_[at(bodies_.element(e)[0])]);
    area_[part] += std::abs(area_of(bodies_, x, e) / area_of(below_, below_.x, at(element_below_[e])));
    outline_[part] += length_of_outline(e, *spacing);
  }
  ThinBody thin;
  for (std::size_t part = 0; part < area_.size(); ++part) {
    const double cells = thickness_of(area_[part], outline_[part]);
    if (area_[part] > 0 && (thin.region < 0 || cells < thin.cells)) thin = {region_[part], cells};
  }
  return thin;
}

}  // namespace tether
