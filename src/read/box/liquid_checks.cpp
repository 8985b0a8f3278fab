// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <optional>

#include "base/numbers.hpp"
#include "grid/crossings.hpp"
#include "grid/solid_surface.hpp"
#include "model/solids.hpp"
#include "read/box/checks.hpp"
#include "read/values.hpp"

namespace tether {
namespace {

/// Reports what a liquid with a surface cannot have in its box.
class LiquidChecks {
 public:
  LiquidChecks(const Deck& deck, const Scene& scene, const Coupled& coupled, Diagnostics& diagnostics)
      : deck_(deck), scene_(scene), coupled_(coupled), grid_(coupled.grid), diagnostics_(diagnostics) {}

  /// Says what has no effect without a liquid.
  void without() {
    for (const AnyVariable name : Variables{"coupled.liquid_box", "coupled.liquid_ellipse", "coupled.liquid_polygon",
                                            "coupled.liquid_below", "coupled.liquid_where", "coupled.liquid_velocity",
                                            "coupled.liquid_particles", "coupled.liquid_jitter", "coupled.air"}) {
      const auto given = deck_.given_elements(name);
      const auto first = std::ranges::find_if(given, [&](const Subscript& at) { return !is_default(deck_, name, at); });
      if (first == given.end()) continue;
      error(name, *first, fmt::format("{} has no effect: the fluid fills the box", name.name()),
            "liquid=.true. of $coupled makes it a liquid with a surface");
    }
  }

  void others() {
    if (coupled_.smoke)
      error("coupled.liquid", {1, 1}, "a liquid with a surface carries no smoke", "leave the smoke away");
    if (!coupled_.voids.empty())
      error(
          "coupled.void", {1, deck_.given_elements("coupled.void")[0][1]}, "a liquid has air wherever it is not",
          "leave void away, and give the regions of liquid: liquid_box, liquid_ellipse, liquid_polygon, liquid_below");
    if (coupled_.cavities_only)
      error("coupled.fluid_in", {1, 1}, "a liquid has air wherever it is not", "leave fluid_in away");
    if (!coupled_.coupling.balances_power())
      error("coupled.mode", {1, 1},
            fmt::format("a liquid with a surface is not solved by mode='{}'", word_of(coupled_.coupling.mode)),
            "write mode='cut-cell' or 'symmetric'");
    for (int side = 1; side <= 2 * grid_.dim; ++side) {
      if (coupled_.sides[at(side - 1)] != BoxSide::open) continue;
      error("coupled.side", {side, 1},
            fmt::format("the {} is open to fluid at rest, but a liquid has air beyond", box_side_names[at(side - 1)]),
            "side(k)='void' lets it out; a jet brings some in");
    }
    if (deck_.given("coupled.advection") && !is_default(deck_, "coupled.advection", {1, 1}))
      warn("coupled.advection", "particles carry a liquid along");
  }

  /// Bodies stop at boxes of whole cells alone.
  void obstacles() {
    if (coupled_.shaped.empty() || !scene_.solids()) return;
    const int k = coupled_.shaped[0].number;
    for (const AnyVariable name :
         Variables{"coupled.obstacle_plane", "coupled.obstacle_ellipse", "coupled.obstacle_polygon"}) {
      for (const Subscript at : deck_.given_elements(name)) {
        if (at[1] != k) continue;
        diagnostics_.add(deck_.remark(Severity::warning, name, at,
                                      fmt::format("bodies do not stop at {} {}: they go through it", name.name(), k),
                                      "obstacle(1:6,k) stops them, and so do bodies that supports hold"));
        return;
      }
    }
  }

  /// Regions that bodies and obstacles have all of.
  void regions() {
    const Liquid& liquid = *coupled_.liquid;
    if (liquid.regions.empty() && coupled_.jets.empty())
      error("coupled.liquid", {1, 1}, "there is no liquid: no region holds some at the start, and no jet brings any",
            "give liquid_box, liquid_ellipse, liquid_polygon or liquid_below, or a jet");
    for (const LiquidRegion& region : liquid.regions) {
      if (has_numbers(region)) region_has_room(region);
    }
    if (liquid.air == Air::sealed && !liquid.regions.empty() && !has_air_)
      error("coupled.air", {1, 1}, "there is no air to be sealed: the liquid fills the box", "leave air away");
  }

  /// Warns of steps too long for waves of two cells, whose speed is sqrt(g d / pi).
  void step() {
    const double cell = *std::min_element(grid_.d.begin(), grid_.d.begin() + grid_.dim),
                 pull = std::hypot(scene_.gravity, coupled_.gravity_x), limit = most_of_a_wave * std::sqrt(cell / pull);
    if (pull == 0 || scene_.clock.tstep <= limit) return;
    diagnostics_.add(deck_.remark(
        Severity::warning, "in.tstep", {1, 1},
        fmt::format(
            "steps of {:.4g} are longer than {:.4g}, {} sqrt(cell / gravc): short waves of the surface may grow",
            scene_.clock.tstep, limit, most_of_a_wave),
        "a quarter of sqrt(cell / gravc) follows waves well"));
  }

 private:
  static constexpr double most_of_a_wave = 0.5;

  void error(AnyVariable name, Subscript at, const std::string& message, const std::string& hint) {
    diagnostics_.add(deck_.remark(Severity::error, name, at, message, hint));
  }
  void warn(AnyVariable name, const std::string& hint) {
    diagnostics_.add(deck_.remark(Severity::warning, name, {1, 1},
                                  fmt::format("{} of ${} has no effect on a liquid", name.name(), name.group()), hint));
  }
  /// The variable that gives a region.
  AnyVariable name_of(int region) const {
    for (const AnyVariable name :
         Variables{"coupled.liquid_box", "coupled.liquid_ellipse", "coupled.liquid_polygon", "coupled.liquid_below"}) {
      const auto given = deck_.given_elements(name);
      const auto number = [&](const Subscript& at) { return name.row().rank == 1 ? at[0] : at[1]; };
      if (std::ranges::any_of(given, [&](const Subscript& at) { return number(at) == region; })) return name;
    }
    return "coupled.liquid_where";
  }
  bool has_body(const Vec<3>& x) const {
    if (!scene_.solids()) return false;
    if (!surface_) surface_ = surface_of(scene_.solids()->mesh);
    return turns_about(*surface_, scene_.solids()->mesh.x, x, -1) > 0.5;
  }
  /// Reports an expression that has no finite value somewhere.
  bool has_numbers(const LiquidRegion& region) {
    const Below* below = std::get_if<Below>(&region.shape);
    if (below == nullptr) return true;
    for (int k = 0; k <= grid_.n[2]; ++k) {
      for (int i = 0; i <= grid_.n[0]; ++i) {
        const double x = grid_.face_place(0, i), z = grid_.dim == 3 ? grid_.face_place(2, k) : 0;
        const double height = (*below->height)(std::array{x, z});
        if (std::isfinite(height)) continue;
        error("coupled.liquid_below", {region.number, 1},
              fmt::format("'{}' gives {} at x = {:.6g}, z = {:.6g}", below->height->text(), height, x, z),
              "it must have a finite value all over the box");
        return false;
      }
    }
    return true;
  }

  /// Looks at so many places of each cell; small regions may lie between them.
  void region_has_room(const LiquidRegion& region) {
    constexpr int places = 4;
    bool any = false, free = false;
    std::array<int, 3> n{1, 1, 1}, i{};
    for (std::size_t a = 0; a < at(grid_.dim); ++a) n[a] = places * grid_.n[a];
    for (i[2] = 0; i[2] < n[2]; ++i[2]) {
      for (i[1] = 0; i[1] < n[1]; ++i[1]) {
        for (i[0] = 0; i[0] < n[0]; ++i[0]) {
          if (free && has_air_) return;
          Vec<3> x{};
          for (std::size_t a = 0; a < at(grid_.dim); ++a) x[a] = grid_.low[a] + (i[a] + 0.5) / places * grid_.d[a];
          const bool in = contains(region, x);
          has_air_ = has_air_ || !in;
          any = any || in;
          free = free || (in && !in_obstacle(coupled_, x) && !has_body(x));
        }
      }
    }
    if (!any || free) return;
    const AnyVariable name = name_of(region.number);
    const Subscript at = name.row().rank == 1 ? Subscript{region.number, 1} : Subscript{1, region.number};
    error(name, at,
          fmt::format("region {} of liquid lies in bodies and obstacles: there is no room for it", region.number),
          "bodies and obstacles have their places before liquid");
  }

  const Deck& deck_;
  const Scene& scene_;
  const Coupled& coupled_;
  const StaggeredGrid& grid_;
  Diagnostics& diagnostics_;
  mutable std::optional<SolidSurface> surface_;  // of bodies, once it was asked for
  bool has_air_ = false;
};

}  // namespace

void check_liquid(const Deck& deck, const Scene& scene, const Coupled& coupled, Diagnostics& diagnostics) {
  LiquidChecks checks(deck, scene, coupled, diagnostics);
  checks.obstacles();
  if (!coupled.liquid) return checks.without();
  checks.others();
  checks.regions();
  checks.step();
}

}  // namespace tether
