// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/find_strip.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>
#include <tuple>

namespace tether {
namespace {

/// Part of a cell by which pairs of points may be off their strip's middle: what rounding makes of a lattice.
constexpr double off_the_middle = 1e-9;

/// The sides along a strip, in the order of edge_names.
std::array<std::size_t, 2> sides_along(int across) {
  return across == 1 ? std::array<std::size_t, 2>{2, 3} : std::array<std::size_t, 2>{0, 1};
}

const std::vector<double>& along(const PointSet& points, int across) { return across == 1 ? points.x : points.y; }
const std::vector<double>& over(const PointSet& points, int across) { return across == 1 ? points.y : points.x; }

std::optional<NoStrip> refuse_grid(const Scene& scene) {
  const BackgroundGrid& grid = scene.grid;
  if (grid.cells_x() > 1 && grid.cells_y() > 1)
    return NoStrip{fmt::format("several cells lie across: the grid has {} x {}", grid.cells_x(), grid.cells_y()),
                   "a strip has one cell across: ny=2 where it runs along x, nx=2 along y"};
  if (grid.cells_y() > 1 && scene.geometry == Geometry::axisymmetric)
    return NoStrip{"about an axis a strip along y has points of several radii abreast",
                   "only along x, the radius, are points abreast alike"};
  return std::nullopt;
}

std::optional<NoStrip> refuse_walls(const Scene& scene, int across) {
  static constexpr std::array<const char*, 4> variables{"wl", "wr", "wb", "wt"};
  const std::array<Wall, 4> walls{scene.walls.left, scene.walls.right, scene.walls.bottom, scene.walls.top};
  if (scene.edges.any()) return NoStrip{"gas passes an edge of the grid", "a strip has walls all round"};
  for (const std::size_t k : sides_along(across)) {
    if (mirrors(walls[k])) continue;
    return NoStrip{fmt::format("the {} wall, along the strip, does not let it slip ({}={})", edge_names[k],
                               variables[k], static_cast<int>(walls[k])),
                   fmt::format("{0}=6 or {0}=4 holds what crosses it and nothing along it", variables[k])};
  }
  return std::nullopt;
}

/// What acts on bodies otherwise than through the nodes, or across the strip.
std::optional<NoStrip> refuse_bodies(const Scene& scene, int across) {
  if (across == 1 && scene.gravity != 0)
    return NoStrip{fmt::format("gravc = {:.6g} acts across it", scene.gravity),
                   "gravc=0, or a strip along y, with nx=2"};
  for (const Body& body : scene.bodies) {
    if (std::holds_alternative<Membrane>(body.material))
      return NoStrip{fmt::format("{} is a string or membrane, whose points are no rows", body.name),
                     "a strip has solids, gas and linear fluids alone"};
  }
  if (scene.method.contact != ContactRule::none && may_touch(scene))
    return NoStrip{"contact acts where points of two bodies meet, one by one",
                   "contact='none' of $mpm lets bodies share one field, which is the same for all rows"};
  return std::nullopt;
}

/// Numbers of a body's points at one place along the strip, by their places across.
using Abreast = std::span<const std::uint32_t>;

/// A property that points abreast have in common.
struct Shared {
  const char* name;
  std::vector<double> PointSet::*of;
};
constexpr std::array shared{Shared{"mass", &PointSet::mass},     Shared{"volume", &PointSet::volume},
                            Shared{"vx", &PointSet::vx},         Shared{"vy", &PointSet::vy},
                            Shared{"stress xx", &PointSet::sxx}, Shared{"stress yy", &PointSet::syy},
                            Shared{"stress xy", &PointSet::sxy}};

/// Judges what the points abreast of one body have, and where they are.
class AbreastCheck {
 public:
  AbreastCheck(const Scene& scene, int across, const Body& body)
      : P_(scene.points),
        across_(across),
        body_(body),
        middle_(across == 1 ? 0.5 * (scene.grid.y0 + scene.grid.y1) : 0.5 * (scene.grid.x0 + scene.grid.x1)),
        slack_(off_the_middle * (across == 1 ? scene.grid.dy : scene.grid.dx)) {}

  double middle() const { return middle_; }

  std::optional<NoStrip> refuse(Abreast points) const {
    for (const auto& judge : {&AbreastCheck::unlike, &AbreastCheck::across, &AbreastCheck::uneven}) {
      if (auto found = (this->*judge)(points)) return found;
    }
    return std::nullopt;
  }

 private:
  std::optional<NoStrip> unlike(Abreast points) const {
    for (const Shared& property : shared) {
      const std::vector<double>& values = P_.*property.of;
      for (const std::uint32_t p : points) {
        if (values[p] == values[points[0]]) continue;
        return NoStrip{fmt::format("points {} and {} of {}, abreast, differ in {}: {:.6g} and {:.6g}", points[0] + 1,
                                   p + 1, body_.name, property.name, values[points[0]], values[p]),
                       "points at one place along the strip run as one where they are alike"};
      }
    }
    return std::nullopt;
  }
  std::optional<NoStrip> across(Abreast points) const {
    const std::uint32_t p = points[0];
    const double v = across_ == 1 ? P_.vy[p] : P_.vx[p];
    if (v != 0)
      return NoStrip{fmt::format("point {} of {} moves across it, at {:.6g}", p + 1, body_.name, v),
                     "a strip moves along itself alone"};
    if (P_.sxy[p] != 0)
      return NoStrip{fmt::format("point {} of {} is sheared, by a stress xy of {:.6g}", p + 1, body_.name, P_.sxy[p]),
                     "what is uniform across between walls that slip has no shear"};
    return std::nullopt;
  }
  /// Pairs from the outside in must have the strip's middle between them.
  std::optional<NoStrip> uneven(Abreast points) const {
    const std::vector<double>& place = over(P_, across_);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const std::uint32_t p = points[k], q = points[points.size() - 1 - k];
      if (std::abs(0.5 * (place[p] + place[q]) - middle_) <= slack_) continue;
      const char axis = across_ == 1 ? 'y' : 'x';
      return NoStrip{fmt::format("{} points of {} abreast, of which the first is number {}, do not lie in pairs about "
                                 "the strip's middle, {} = {:.6g}",
                                 points.size(), body_.name, points[0] + 1, axis, middle_),
                     "a body fills the strip from wall to wall, or lies in its middle"};
    }
    return std::nullopt;
  }

  const PointSet& P_;
  int across_;
  const Body& body_;
  double middle_, slack_;
};

/// The body's points, those at one place along the strip next to each other in their order across.
std::vector<std::uint32_t> along_the_strip(const PointSet& points, int across, const Body& body) {
  std::vector<std::uint32_t> order(body.count);
  std::iota(order.begin(), order.end(), static_cast<std::uint32_t>(body.first));
  const std::vector<double>&first = along(points, across), &second = over(points, across);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::tuple(first[a], second[a], a) < std::tuple(first[b], second[b], b);
  });
  return order;
}

/// Splits them where the place along the strip changes.
std::vector<Abreast> split(const std::vector<std::uint32_t>& order, const std::vector<double>& place) {
  std::vector<Abreast> all;
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    while (end < order.size() && place[order[end]] == place[order[begin]]) ++end;
    all.push_back(Abreast(order).subspan(begin, end - begin));
  }
  return all;
}

/// Adds the body's part of the row.
std::optional<NoStrip> add_body(const Scene& scene, const Body& body, Strip& strip) {
  const AbreastCheck check(scene, strip.across, body);
  const std::vector<std::uint32_t> order = along_the_strip(scene.points, strip.across, body);
  std::vector<Abreast> all = split(order, along(scene.points, strip.across));
  for (const Abreast points : all) {
    if (auto found = check.refuse(points)) return found;
  }
  std::ranges::sort(all, {}, [](Abreast points) { return std::ranges::min(points); });
  for (const Abreast points : all) {
    for (const std::uint32_t p : points) strip.row[p] = static_cast<std::uint32_t>(strip.first.size());
    strip.first.push_back(std::ranges::min(points));
    strip.abreast.push_back(static_cast<std::uint32_t>(points.size()));
  }
  strip.middle = check.middle();
  return std::nullopt;
}

}  // namespace

std::variant<Strip, NoStrip> find_strip(const Scene& scene) {
  if (auto found = refuse_grid(scene)) return *found;
  Strip strip;
  strip.across = scene.grid.cells_y() == 1 ? 1 : 0;
  if (auto found = refuse_walls(scene, strip.across)) return *found;
  if (auto found = refuse_bodies(scene, strip.across)) return *found;
  strip.row.resize(scene.points.size());
  for (const Body& body : scene.bodies) {
    if (auto found = add_body(scene, body, strip)) return *found;
  }
  strip.place = over(scene.points, strip.across);
  return strip;
}

std::size_t points_that_run(const Scene& scene) {
  return scene.strip ? scene.strip->first.size() : scene.points.size();
}

Scene scene_of_row(const Scene& scene) {
  Scene row = scene;
  row.points = {};
  std::size_t first = 0;
  for (Body& body : row.bodies) {
    const auto& numbers = scene.strip->row;
    const auto begin = numbers.begin() + static_cast<std::ptrdiff_t>(body.first);
    body.first = first;
    body.count = 1 + *std::max_element(begin, begin + static_cast<std::ptrdiff_t>(body.count)) - first;
    first += body.count;
  }
  return row;
}

PointSet points_of_row(const Strip& strip, const PointSet& points) {
  PointSet row;
  const auto take = [&](std::vector<double> PointSet::*array) {
    for (const std::uint32_t p : strip.first) (row.*array).push_back((points.*array)[p]);
  };
  for (const Shared& property : shared) take(property.of);
  take(&PointSet::x), take(&PointSet::y);
  (strip.across == 1 ? row.y : row.x).assign(row.size(), strip.middle);
  for (std::size_t k = 0; k < row.size(); ++k) row.volume[k] *= strip.abreast[k], row.mass[k] *= strip.abreast[k];
  return row;
}

}  // namespace tether
