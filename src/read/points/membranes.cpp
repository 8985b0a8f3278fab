// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/points/membranes.hpp"

#include <fmt/format.h>

#include <optional>

#include "base/vec.hpp"
#include "deck/words.hpp"
#include "model/string_gaps.hpp"
#include "read/bodies.hpp"
#include "read/limits.hpp"
#include "read/materials.hpp"
#include "read/points/membrane_curves.hpp"
#include "read/values.hpp"

namespace tether {
namespace {

/// Reads one membrane's values and reports what is wrong with them at their places.
class MembraneReader {
 public:
  MembraneReader(const Deck& deck, int b, Diagnostics& diagnostics)
      : deck_(deck), b_(b), diagnostics_(diagnostics), first_curve_(curve_numbers(deck, b).front()) {}

  void error(AnyVariable name, Subscript at, const std::string& message, const std::string& hint) const {
    diagnostics_.add(deck_.remark(Severity::error, name, at, labelled(message), hint));
  }
  void error(AnyVariable name, const std::string& message, const std::string& hint) const {
    error(name, {b_, 1}, message, hint);
  }
  void error_at_curve(const std::string& message, const std::string& hint) const {
    error("membrane.curve", {first_curve_, 1}, message, hint);
  }

  /// At what says how many points there are.
  void add(const GapRemark& remark) const {
    const AnyVariable name = deck_.given("membrane.count", b_) ? AnyVariable("membrane.count") : "membrane.spacing";
    diagnostics_.add(deck_.remark(remark.severity, name, {b_, 1}, labelled(remark.message), remark.hint));
  }

  /// A value that every membrane of curves needs; 1 where it is not given.
  double required(RealVariable name) const {
    if (deck_.given(name, b_)) return deck_.real(name, b_);
    error_at_curve(fmt::format("{}({}) is not given", name, b_),
                   "a membrane needs density, young, thickness, and count or spacing");
    return 1;
  }
  Membrane law() const {
    const double nu = deck_.real("membrane.poisson", b_);
    const Membrane law = membrane_law(deck_, b_, required("membrane.young"), nu);
    const bool uniaxial = law.kind == Membrane::Kind::uniaxial;
    if (uniaxial && nu != 0) {
      diagnostics_.add(deck_.remark(Severity::warning, "membrane.poisson", {b_, 1},
                                    labelled(fmt::format("poisson({0}) has no effect: law({0}) is 'uniaxial'", b_)),
                                    fmt::format("law({})='plane-stress' uses it", b_)));
    }
    if (!uniaxial && !(nu > -1)) error("membrane.poisson", "Poisson's ratio -1 is out of range", "-1 < nu <= 0.5");
    return law;
  }
  EndPoints ends() const {
    const auto pinned = word<PinnedEnds>(deck_, "membrane.pinned", b_);
    return {pinned == PinnedEnds::first || pinned == PinnedEnds::both,
            pinned == PinnedEnds::last || pinned == PinnedEnds::both};
  }
  /// The deck must say how many points there are, in one way only.
  void check_count() const {
    const bool count = deck_.given("membrane.count", b_), spacing = deck_.given("membrane.spacing", b_);
    if (count && spacing) {
      error("membrane.spacing", fmt::format("count({0}) and spacing({0}) are both given", b_), "leave one of them out");
    }
    if (!count && !spacing) {
      error_at_curve(fmt::format("neither count({0}) nor spacing({0}) is given", b_),
                     "give the number of points, or their distance");
    }
  }
  /// The number of points, small enough to be held; 0 where there cannot be so few or so many.
  std::size_t count(const Curve& curve, bool closed, const Scene& scene) const {
    const bool given = deck_.given("membrane.count", b_);
    const AnyVariable name = given ? AnyVariable("membrane.count") : "membrane.spacing";
    const double n =
        given ? deck_.integer("membrane.count", b_) : seed_count(curve, deck_.real("membrane.spacing", b_), ends());
    const int least = closed ? 3 : 2;
    if (n < least) {
      error(name, fmt::format("too few points on a length of {:.6g}: {:.0f}", curve.length(), n),
            fmt::format("{} membrane needs {} points at least", closed ? "a closed" : "an open", least));
      return 0;
    }
    const std::string too_large = memory_refusal(scene.grid, static_cast<double>(scene.points.size()) + n);
    if (!too_large.empty()) return error(name, too_large, "use fewer points"), 0;
    if (n > point_count) {
      error(name, fmt::format("{:.0f} points on a length of {:.6g} are too many", n, curve.length()),
            fmt::format("a membrane has {} points at most", point_count));
      return 0;
    }
    return static_cast<std::size_t>(n);
  }

 private:
  std::string labelled(const std::string& message) const { return fmt::format("membrane {}: {}", b_, message); }

  const Deck& deck_;
  int b_;
  Diagnostics& diagnostics_;
  int first_curve_;
};

Curve joined(const std::vector<NumberedCurve>& curves) {
  std::vector<Curve> parts;
  parts.reserve(curves.size());
  for (const auto& [k, curve] : curves) parts.push_back(curve);
  return joined(parts);
}

/// Number of the curve on which arc length s of the chain lies.
int curve_at(const std::vector<NumberedCurve>& curves, double s) {
  for (const auto& [k, curve] : curves) {
    if (s <= curve.length()) return k;
    s -= curve.length();
  }
  return curves.back().k;
}

/// Reports points where none can be; for each mistake of the first of its kind, with the number of them.
void check_places(const MembraneReader& reader, const Seeds& points, const std::vector<NumberedCurve>& curves,
                  const Scene& scene) {
  struct Wrong {
    std::size_t count = 0, first = 0;
    double s = 0;
    void note(std::size_t k, double at) {
      if (count++ == 0) first = k, s = at;
    }
  } outside, on_axis;
  double s = 0;
  for (std::size_t k = 0; k < points.places.size(); ++k) {
    const Vec<2>& at = points.places[k];
    const double middle = s + 0.5 * points.pieces[k];
    s += points.pieces[k];
    if (!scene.grid.contains(at[0], at[1])) outside.note(k, middle);
    if (scene.geometry == Geometry::axisymmetric && at[0] == 0) on_axis.note(k, middle);
  }
  const BackgroundGrid& grid = scene.grid;
  const auto tell = [&](const Wrong& wrong, const char* what, const std::string& hint) {
    if (wrong.count == 0) return;
    const Vec<2>& at = points.places[wrong.first];
    reader.error("membrane.curve", {curve_at(curves, wrong.s), 1},
                 fmt::format("points {}: {} of {}, the first at ({:.6g}, {:.6g})", what, wrong.count,
                             points.places.size(), at[0], at[1]),
                 hint);
  };
  tell(outside, "outside the grid",
       fmt::format("the grid spans x {:.6g} to {:.6g}, y {:.6g} to {:.6g}", grid.x0, grid.x1, grid.y0, grid.y1));
  tell(on_axis, "on the axis", "a ring of radius 0 has no volume: an unpinned end may touch the axis");
}

void append(const Seeds& seeds, double thickness, double density, Geometry geometry, PointSet& points) {
  for (std::size_t k = 0; k < seeds.places.size(); ++k) {
    const Vec<2>& at = seeds.places[k];
    const double volume = thickness * seeds.pieces[k] * depth(geometry, at[0]);
    points.x.push_back(at[0]), points.y.push_back(at[1]);
    points.vx.push_back(0), points.vy.push_back(0);
    points.sxx.push_back(0), points.syy.push_back(0), points.sxy.push_back(0);
    points.volume.push_back(volume), points.mass.push_back(density * volume);
  }
}

void pin_ends(const Deck& deck, int b, EndPoints ends, Scene& scene, Diagnostics& diagnostics) {
  const Body& body = scene.bodies.back();
  std::vector<std::size_t> pinned;
  if (ends.first) pinned.push_back(body.first);
  if (ends.last) pinned.push_back(body.first + body.count - 1);
  if (!pinned.empty()) pin_points(deck, "membrane.pinned", {b, 1}, pinned, scene, diagnostics);
}

/// Masses on the first and the last point, which keep their volume.
void weigh_ends(const Deck& deck, int b, Scene& scene) {
  const Body& body = scene.bodies.back();
  if (deck.given("membrane.heavy", 1, b)) scene.points.mass[body.first] = deck.real("membrane.heavy", 1, b);
  if (deck.given("membrane.heavy", 2, b)) {
    scene.points.mass[body.first + body.count - 1] = deck.real("membrane.heavy", 2, b);
  }
}

/// The points of a membrane's curves, which have no mistake of their own; none where there cannot be such points.
std::optional<Seeds> points_of(const MembraneReader& reader, const Curve& curve, const Scene& scene) {
  const bool closed = is_closed(curve);
  const EndPoints ends = reader.ends();
  const bool pinned = ends.first || ends.last;
  if (closed && pinned)
    reader.error("membrane.pinned", "it is closed and has no end to pin", "leave it open, or write pinned='none'");
  const std::size_t n = reader.count(curve, closed, scene);
  if (n == 0 || (closed && pinned)) return std::nullopt;
  return seeds(curve, n, ends);
}

void add_membrane(const Deck& deck, int b, Scene& scene, Diagnostics& diagnostics) {
  const MembraneReader reader(deck, b, diagnostics);
  const std::size_t errors_before = diagnostics.errors().size();
  const auto curves = curves_of(deck, b, diagnostics);
  if (curves.size() == curve_numbers(deck, b).size()) check_joints(deck, curves, diagnostics);
  const Membrane law = reader.law();
  const double density = reader.required("membrane.density"), thickness = reader.required("membrane.thickness");
  reader.check_count();
  if (diagnostics.errors().size() > errors_before) return;

  const Curve curve = joined(curves);
  const auto points = points_of(reader, curve, scene);
  if (points) check_places(reader, *points, curves, scene);
  if (diagnostics.errors().size() > errors_before) return;

  const std::size_t first = scene.points.size(), n = points->places.size();
  append(*points, thickness, density, scene.geometry, scene.points);
  scene.bodies.push_back({fmt::format("membrane {}", b), law, density, 0, first, n, is_closed(curve)});
  weigh_ends(deck, b, scene);
  pin_ends(deck, b, reader.ends(), scene, diagnostics);
  for (const GapRemark& remark : gap_remarks(scene, scene.bodies.back())) reader.add(remark);
}

/// Reports the first value of a membrane that has no curve. Of the first one the particle file's string takes the law.
void check_without_curves(const Deck& deck, int b, Diagnostics& diagnostics) {
  for (const int end : {1, 2}) {
    if (!deck.given("membrane.heavy", end, b)) continue;
    return diagnostics.add(
        deck.remark(Severity::error, "membrane.heavy", {end, b},
                    fmt::format("heavy({},{}) is given, and no curve belongs to membrane {}", end, b, b),
                    "rows of a particle file have their masses from heavy in $points"));
  }
  for (const AnyVariable name :
       Variables{"membrane.count", "membrane.spacing", "membrane.thickness", "membrane.density", "membrane.young",
                 "membrane.poisson", "membrane.pinned", "membrane.law", "membrane.wrinkle"}) {
    const bool of_file = b == 1 && (name == "membrane.law" || name == "membrane.wrinkle");
    if (of_file || !deck.given(name, b)) continue;
    return diagnostics.add(deck.remark(Severity::error, name, {b, 1},
                                       fmt::format("{}({}) is given, and no curve belongs to membrane {}", name, b, b),
                                       fmt::format("give one: curve(k)='line', body(k)={}", b)));
  }
}

}  // namespace

void add_membranes(const Deck& deck, Scene& scene, Diagnostics& diagnostics) {
  check_kinds(deck, diagnostics);
  for (int b = 1; b <= membrane_count; ++b) {
    if (curve_numbers(deck, b).empty())
      check_without_curves(deck, b, diagnostics);
    else
      add_membrane(deck, b, scene, diagnostics);
  }
}

}  // namespace tether
