// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <tuple>
#include <vector>

#include "model/string_gaps.hpp"
#include "read/bodies.hpp"
#include "read/materials.hpp"

namespace tether {
namespace {

/// Reports the first two rows in one place: two points that are one, or no string between them.
void check_places(const ParticleFile& file, Diagnostics& diagnostics) {
  std::vector<std::size_t> order(file.rows.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto key = [&file](std::size_t k) { return std::tuple(file.rows[k].x, file.rows[k].y, k); };
  std::sort(order.begin(), order.end(), [&key](std::size_t a, std::size_t b) { return key(a) < key(b); });
  std::size_t count = 0, first = 0, twin = file.rows.size();
  for (std::size_t k = 1; k < order.size(); ++k) {
    const ParticleRow &one = file.rows[order[k - 1]], &other = file.rows[order[k]];
    if (one.x != other.x || one.y != other.y) continue;
    ++count;
    if (order[k] < twin) first = order[k - 1], twin = order[k];
  }
  if (count == 0) return;
  const ParticleRow& row = file.rows[twin];
  diagnostics.error({file.file, row.line, 1}, line_text(file, row.line),
                    fmt::format("point {} at ({:.6g}, {:.6g}) is where point {} is{}", twin + 1, row.x, row.y,
                                first + 1, count > 1 ? fmt::format("; so are {} more", count - 1) : ""),
                    "each point has a place of its own");
}

void check_file(const ParticleFile& file, const Material& material, const Scene& scene, Diagnostics& diagnostics) {
  const BackgroundGrid& grid = scene.grid;
  for (std::size_t k = 0; k < file.rows.size(); ++k) {
    const ParticleRow& row = file.rows[k];
    if (scene.geometry == Geometry::axisymmetric && row.x == 0) {
      diagnostics.error({file.file, row.line, 1}, line_text(file, row.line),
                        fmt::format("point {} at (0, {:.6g}) lies on the axis", k + 1, row.y),
                        "a ring of radius 0 has no volume");
    }
    if (grid.contains(row.x, row.y)) continue;
    diagnostics.error(
        {file.file, row.line, 1}, line_text(file, row.line),
        fmt::format("point {} at ({:.6g}, {:.6g}) lies outside the grid", k + 1, row.x, row.y),
        fmt::format("the grid spans x {:.6g} to {:.6g}, y {:.6g} to {:.6g}", grid.x0, grid.x1, grid.y0, grid.y1));
  }
  if (!std::holds_alternative<Membrane>(material)) return;
  if (file.rows.size() < 2) {
    diagnostics.error({file.file, 0, 0}, {}, "a string needs at least 2 points",
                      "its tangent comes from its neighbours");
  }
  if (file.in_sequence != file.total) {
    diagnostics.error(
        {file.file, 0, 0}, {},
        fmt::format("{} points in the sequence, {} in total: a string is one sequence", file.in_sequence, file.total),
        "write the same number twice");
  }
}

}  // namespace

void add_file_body(const Deck& deck, const ParticleFile& file, Scene& scene, Diagnostics& diagnostics) {
  const auto material = file_material(deck, file, diagnostics);
  if (!material) return;
  check_file(file, *material, scene, diagnostics);
  check_places(file, diagnostics);
  const std::size_t first = scene.points.size();
  const double area = scene.grid.dx * scene.grid.dy / file.per_cell;
  PointSet& points = scene.points;
  for (const ParticleRow& row : file.rows) {
    const double volume = area * depth(scene.geometry, row.x);
    points.x.push_back(row.x), points.y.push_back(row.y);
    points.vx.push_back(row.vx), points.vy.push_back(row.vy);
    points.sxx.push_back(row.sxx), points.syy.push_back(row.syy), points.sxy.push_back(row.sxy);
    points.volume.push_back(volume), points.mass.push_back(file.density * volume);
  }
  scene.bodies.push_back({"particle file", *material, file.density, 0, first, file.rows.size()});
}

void tell_file_gaps(const ParticleFile& file, const Body& body, const Scene& scene, Diagnostics& diagnostics) {
  for (const GapRemark& remark : gap_remarks(scene, body)) {
    const int line = file.rows[remark.point].line;
    Diagnostic said;
    said.severity = remark.severity;
    said.place = {file.file, line, 1};
    said.line_text = line_text(file, line);
    said.message = remark.message, said.hint = remark.hint;
    diagnostics.add(said);
  }
}

}  // namespace tether
