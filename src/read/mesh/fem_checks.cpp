// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/mesh/fem_checks.hpp"

#include <fmt/format.h>

#include <cmath>

#include "deck/spelling.hpp"
#include "model/bars.hpp"
#include "read/points/geometry.hpp"
#include "read/points/membrane_curves.hpp"
#include "read/values.hpp"

namespace tether {
namespace {

/// Points nearer to each other, over the size of the scene, are apart by rounding alone.
constexpr double one_place = 1e-12;

constexpr const char* use_points = "strings alone become bars; --path mpm runs it by material points";

void check_regions(const Deck& deck, Diagnostics& diagnostics) {
  if (deck.integer("in.igen") == 0) return;
  for (const int r : regions_of(deck)) {
    const int ipath = deck.given("reg.ipath", 4, r) ? deck.integer("reg.ipath", 4, r) : -1;
    const char* what = ipath == 7 || ipath == 9   ? "a gas"
                       : ipath == 8               ? "a linear fluid"
                       : ipath == 0 || ipath == 2 ? "a solid of points without a mesh"
                                                  : nullptr;
    if (!what) continue;  // reported already: it names no law
    diagnostics.add(deck.remark(Severity::error, "reg.ipath", {4, r},
                                fmt::format("region {}: the fem path cannot represent {}", r, what), use_points));
  }
}

void check_file(const ParticleFile& file, Diagnostics& diagnostics) {
  if (file.ipath[3] != 0 && file.ipath[3] != 2) return;
  diagnostics.error({file.file, file.ipath_line, 1}, line_text(file, file.ipath_line),
                    "the fem path cannot represent a solid of points without a mesh",
                    "a string has ipath(4) = 8; --path mpm runs it by material points");
}

void check_membrane_laws(const Deck& deck, const std::optional<ParticleFile>& particles, Diagnostics& diagnostics) {
  for (int b = 1; b <= membrane_count; ++b) {
    const bool of_file = b == 1 && particles && particles->ipath[3] == 8;
    if (word<Membrane::Kind>(deck, "membrane.law", b) != Membrane::Kind::plane_stress ||
        (!of_file && curve_numbers(deck, b).empty()))
      continue;
    diagnostics.add(deck.remark(Severity::error, "membrane.law", {b, 1},
                                fmt::format("the fem path cannot represent plane stress: law({})", b),
                                "a bar carries along itself only: law='uniaxial'; --path mpm has plane stress"));
  }
}

/// Reports at the place where a string's points were given: a row of the file, or its membrane's first curve.
void tell_at_point(const Deck& deck, const std::optional<ParticleFile>& particles, const Body& body, std::size_t p,
                   const std::string& message, Diagnostics& diagnostics) {
  constexpr const char* hint = "a bar needs a length";
  if (body.name == "particle file" && particles) {
    const int line = particles->rows[p - body.first].line;
    return diagnostics.error({particles->file, line, 1}, line_text(*particles, line), message, hint);
  }
  for (int b = 1; b <= membrane_count; ++b) {
    if (body.name != fmt::format("membrane {}", b)) continue;
    diagnostics.add(deck.remark(Severity::error, "membrane.curve", {curve_numbers(deck, b).front(), 1}, message, hint));
  }
}

void check_lengths(const Deck& deck, const std::optional<ParticleFile>& particles, const Scene& scene,
                   Diagnostics& diagnostics) {
  const PointSet& P = scene.points;
  const double shortest = one_place * std::hypot(scene.grid.x1 - scene.grid.x0, scene.grid.y1 - scene.grid.y0);
  for (const Body& body : scene.bodies) {
    if (!std::holds_alternative<Membrane>(body.material)) continue;
    for (std::size_t k = body.closed ? 0 : 1; k < body.count; ++k) {
      const std::size_t p = body.first + k, before = k == 0 ? body.first + body.count - 1 : p - 1;
      const double length = std::hypot(P.x[p] - P.x[before], P.y[p] - P.y[before]);
      if (length > shortest || (length == 0 && body.name == "particle file"))
        continue;  // of rows in one place it is reported
      tell_at_point(deck, particles, body, p,
                    fmt::format("points {} and {} of the string stand in one place, ({:.6g}, {:.6g})",
                                before - body.first + 1, k + 1, P.x[p], P.y[p]),
                    diagnostics);
    }
  }
}

/// Warns of what the deck asks of material points, other than what they do by themselves. Where the path is named, the
/// deck is one for several paths, and it does no harm there.
void warn_of_the_other_method(const Deck& deck, Diagnostics& diagnostics) {
  const Severity severity = deck.given("in.path") ? Severity::remark : Severity::warning;
  for (const Variable& variable : variables()) {
    const AnyVariable name(variable);
    if (variable.group != "mpm" || !deck.given(name)) continue;
    if (is_default(deck, name, {1, 1})) continue;
    diagnostics.add(
        deck.remark(severity, name, {1, 1}, fmt::format("{} of $mpm has no effect on the fem path", variable.name)));
  }
}

}  // namespace

void check_fem(const Deck& deck, const std::optional<ParticleFile>& particles, const Scene& scene,
               Diagnostics& diagnostics) {
  if (geometry_of(deck) == Geometry::axisymmetric) {
    diagnostics.add(deck.remark(Severity::error, "in.cyl", {1, 1}, "the fem path is plane: it has no axis",
                                "write cyl=0.; --path mpm runs bodies of revolution"));
  }
  if (deck.real("fluid.pambient") != 0) {
    diagnostics.add(deck.remark(Severity::error, "fluid.pambient", {1, 1},
                                "the fem path has no pressure outside membranes", "write pambient=0."));
  }
  check_regions(deck, diagnostics);
  if (particles) check_file(*particles, diagnostics);
  check_membrane_laws(deck, particles, diagnostics);
  check_lengths(deck, particles, scene, diagnostics);
  warn_of_the_other_method(deck, diagnostics);
}

void drop_grid_outputs(const Deck& deck, Scene& scene, Diagnostics& diagnostics) {
  if (!std::holds_alternative<Bars>(scene.physics) || scene.outputs.grid == 0) return;
  scene.outputs.grid = 0;
  for (const int k : {30, 31, 37, 39}) {
    if (deck.integer("in.iout", k) != 1) continue;
    diagnostics.add(deck.remark(Severity::warning, "in.iout", {k, 1},
                                fmt::format("iout({})=1 writes nothing: bars have no grid", k)));
  }
}

}  // namespace tether
