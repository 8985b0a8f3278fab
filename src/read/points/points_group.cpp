// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/points/points_group.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "base/diagnostics.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "read/bodies.hpp"
#include "read/points/membrane_curves.hpp"
#include "read/values.hpp"

namespace tether {
namespace {

namespace fs = std::filesystem;

/// Nothing where not even its header could be read: what would be said of its points has no ground.
std::optional<ParticleFile> read_text(const std::string& text, const std::string& file, int first_line,
                                      Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.errors().size();
  ParticleFile read = read_particle_file(text, file, first_line, diagnostics);
  if (read.rows.empty() && diagnostics.errors().size() > errors_before) return std::nullopt;
  return read;
}

std::optional<ParticleFile> read_path(const fs::path& path, const Diagnostic& missing, Diagnostics& diagnostics) {
  try {
    return read_text(read_file(path), path.string(), 1, diagnostics);
  } catch (const FileError& error) {
    Diagnostic diagnostic = missing;
    diagnostic.message = fmt::format("particle file: {}", error.what());
    diagnostics.add(diagnostic);
    return std::nullopt;
  }
}

std::optional<ParticleFile> read_named(const Deck& deck, const std::string& name, Diagnostics& diagnostics) {
  const std::string mistake = path_mistake(name);
  if (!mistake.empty()) {
    diagnostics.add(deck.remark(Severity::error, "in.particles", {1, 1}, "the particle path " + mistake,
                                path_hint("../particles/x.par") + ", or use --particles FILE"));
    return std::nullopt;
  }
  return read_path(path_beside(deck, name),
                   deck.remark(Severity::error, "in.particles", {1, 1}, "", "the path counts from the deck's folder"),
                   diagnostics);
}

}  // namespace

std::optional<ParticleFile> load_particles(const Deck& deck, const std::optional<fs::path>& given,
                                           Diagnostics& diagnostics) {
  const int igen = deck.integer("in.igen");
  if (igen == 1) {
    if (given)
      diagnostics.add(deck.remark(Severity::warning, "in.igen", {1, 1},
                                  "igen = 1 reads no particle file: --particles is not used"));
    return std::nullopt;
  }
  if (given) {
    Diagnostic missing;
    missing.hint = "named by --particles";
    return read_path(*given, missing, diagnostics);
  }
  const std::string name = deck.text("in.particles");
  if (!name.empty()) return read_named(deck, name, diagnostics);
  if (!trim(deck.trailer().text).empty()) {
    return read_text(deck.trailer().text, deck.file(), deck.trailer().first_line, diagnostics);
  }
  if (igen == 3 && gives_curves(deck)) return std::nullopt;
  const char* last =
      igen == 3 ? "use --particles FILE, or give membranes by $membrane curve" : "or use --particles FILE";
  diagnostics.add(deck.remark(Severity::error, "in.igen", {1, 1},
                              fmt::format("igen = {} takes points from a particle file, and none is named", igen),
                              fmt::format("add particles='../particles/x.par' to $in, put the data after the last "
                                          "group, {}",
                                          last)));
  return std::nullopt;
}

namespace {

/// The scene's number of row i of the particle file; reports where there is no such row.
std::optional<std::size_t> row_number(const Deck& deck, AnyVariable name, Subscript at, std::size_t file_first,
                                      std::size_t file_rows, Diagnostics& diagnostics) {
  const auto row = static_cast<std::size_t>(at[0]);
  if (row <= file_rows) return file_first + row - 1;
  diagnostics.add(
      deck.remark(Severity::error, name, at,
                  fmt::format("{}({}) counts rows of the particle file, which has {}", name, row, file_rows),
                  "the first row is 1"));
  return std::nullopt;
}

std::size_t nearest_point(const PointSet& points, double x, double y) {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t p = 0; p < points.size(); ++p) {
    const double dx = points.x[p] - x, dy = points.y[p] - y, distance = dx * dx + dy * dy;
    if (distance < least) least = distance, best = p;
  }
  return best;
}

bool is_membrane_point(const Scene& scene, std::size_t p) {
  for (const Body& body : scene.bodies) {
    if (p >= body.first && p < body.first + body.count) return std::holds_alternative<Membrane>(body.material);
  }
  return false;
}

void pin_rows(const Deck& deck, std::size_t file_first, std::size_t file_rows, Scene& scene, Diagnostics& diagnostics) {
  std::vector<std::size_t> pinned;
  Subscript first{};
  for (const Subscript at : deck.given_elements("points.pinned")) {
    if (!deck.logical("points.pinned", at[0])) continue;
    const auto p = row_number(deck, "points.pinned", at, file_first, file_rows, diagnostics);
    if (!p) break;
    if (!is_membrane_point(scene, *p)) {
      if (diagnostics.has_errors()) return;  // the file may have become no body for another reason
      diagnostics.add(deck.remark(Severity::error, "points.pinned", at,
                                  "a pin holds points of strings and membranes, and the particle file is none",
                                  "a string has ipath(4) = 8"));
      return;
    }
    if (pinned.empty()) first = at;
    pinned.push_back(*p);
  }
  if (!pinned.empty()) pin_points(deck, "points.pinned", first, pinned, scene, diagnostics);
}

/// Part of a cell from which it is said how far the nearest point is.
constexpr double told_distance = 1e-6;

/// Tracks the point nearest to a place, and says how far away it is.
void track_nearest(const Deck& deck, int k, Scene& scene, Diagnostics& diagnostics) {
  const double x = deck.real("points.tracked_at", 1, k), y = deck.real("points.tracked_at", 2, k);
  const std::size_t p = nearest_point(scene.points, x, y);
  const double away = std::hypot(scene.points.x[p] - x, scene.points.y[p] - y);
  scene.tracked.push_back(p);
  scene.tracked_from.resize(scene.tracked.size());
  scene.tracked_from.back() = fmt::format(", {:.3g} from ({:.6g}, {:.6g})", away, x, y);
  if (away <= told_distance * std::min(scene.grid.dx, scene.grid.dy)) return;
  diagnostics.add(deck.remark(Severity::remark, "points.tracked_at", {1, k},
                              fmt::format("what is tracked is the nearest point, number {} at ({:.6g}, {:.6g}), {:.3g} "
                                          "from ({:.6g}, {:.6g})",
                                          p + 1, scene.points.x[p], scene.points.y[p], away, x, y),
                              "material points have no values between them"));
}

}  // namespace

void pin_points(const Deck& deck, AnyVariable pinned, Subscript at, const std::vector<std::size_t>& points,
                Scene& scene, Diagnostics& diagnostics) {
  scene.pinned.insert(scene.pinned.end(), points.begin(), points.end());
  if (scene.method.membrane_strain == MembraneStrain::element) return;
  diagnostics.add(deck.remark(Severity::warning, pinned, at,
                              "where strain is measured at points a pin holds its point alone, not the nodes around "
                              "it, which carry the load",
                              "a fixed wall holds them; or write strain='element' in $membrane"));
}

void apply_points_group(const Deck& deck, std::size_t file_first, std::size_t file_rows, Scene& scene,
                        Diagnostics& diagnostics) {
  for (const Subscript at : deck.given_elements("points.heavy")) {
    const auto p = row_number(deck, "points.heavy", at, file_first, file_rows, diagnostics);
    if (!p) break;  // the rest is not there either
    scene.points.mass[*p] = deck.real("points.heavy", at[0]);
  }
  for (const Subscript at : deck.given_elements("points.tracked")) {
    if (!deck.logical("points.tracked", at[0])) continue;
    const auto p = row_number(deck, "points.tracked", at, file_first, file_rows, diagnostics);
    if (!p) break;
    scene.tracked.push_back(*p);
  }
  pin_rows(deck, file_first, file_rows, scene, diagnostics);
  for (const Subscript at : deck.given_elements("points.tracked_at")) {
    if (at[0] != 1) continue;
    if (!deck.given("points.tracked_at", 2, at[1])) {
      diagnostics.add(deck.remark(Severity::error, "points.tracked_at", at, "tracked_at needs x and y",
                                  fmt::format("write tracked_at(1,{})=x,y", at[1])));
      continue;
    }
    if (scene.points.size() == 0) continue;
    track_nearest(deck, at[1], scene, diagnostics);
  }
}

}  // namespace tether
