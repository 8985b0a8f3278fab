// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/box/checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "base/numbers.hpp"
#include "deck/elements.hpp"
#include "deck/spelling.hpp"
#include "read/mesh/solids.hpp"
#include "read/values.hpp"

namespace tether {
namespace {

/// Reports what is wrong with a deck of the coupled path, or says nothing there.
class CoupledChecks {
 public:
  CoupledChecks(const Deck& deck, const Coupled& coupled, bool energy, Diagnostics& diagnostics)
      : deck_(deck), coupled_(coupled), energy_(energy), diagnostics_(diagnostics) {}

  /// Warns of what has a use beside bodies on a mesh by finite elements, and none here.
  void others() {
    int side = 0;
    for (const AnyVariable wall : Variables{"in.wl", "in.wr", "in.wb", "in.wt"})
      unused(wall, fmt::format("side({}) of $coupled says what that side is, and bodies stop at it", ++side));
    for (const AnyVariable name : Variables{"fem.static", "fem.settle"}) {
      if (deck_.logical(name))
        error(name, {1, 1}, "solids in a fluid have no equilibrium of their own", "leave it away");
    }
    unused("fem.integrator", "step and integrator of $coupled are those of the solids");
    if (!energy_)
      unused("fem.tolerance", "solids take one linear step, as the paper's; tolerance of $coupled is the solver's");
    unused("fem.cfl", "steps are tstep");
  }
  /// Checks what $coupled says of a third dimension that a plane box does not have.
  void plane() {
    if (coupled_.grid.dim == 3) return;
    for (const int side : {5, 6}) {
      if (!is_wall(word<BoxSide>(deck_, "coupled.side", side)))
        flat("coupled.side", {side, 1}, fmt::format("side {}, the {}, is open", side, box_side_names[at(side - 1)]));
    }
    if (coupled_.start[2] != 0) flat("coupled.w0", {1, 1}, "the fluid starts along z");
    in_depth("coupled.jet", 3), in_depth("coupled.open", 3), in_depth("coupled.obstacle", 5),
        in_depth("coupled.void", 5), in_depth("coupled.smoke_box", 5);
  }
  /// Parts of the method that do nothing without others.
  void method() {
    if (coupled_.friction > 0 && !coupled_.contact)
      error("coupled.friction", {1, 1}, "there is no friction without contact",
            "leave friction away, or contact=.false.");
    if (coupled_.coupling.simultaneous) unused("coupled.area_repair", "mode='splitting' repairs areas");
    if (coupled_.systems == Systems::direct) unused("coupled.tolerance", "factors need none");
    if (coupled_.viscosity == 0) unused("coupled.bodies_slip", "viscosity is 0: the fluid rubs nowhere");
    level();
    if (coupled_.smoke) return;
    for (const AnyVariable name : Variables{"coupled.smoke_weight", "coupled.smoke_lift"})
      unused(
          name,
          "there is no smoke: jet_smoke(k) or jet_temperature(k) brings it, box_smoke(k) or box_temperature(k) has it");
  }
  /// What linear steps cannot, and what those that keep the energy do not ask.
  void step() {
    const bool meets = deck_.has_group("contact");
    if (meets && coupled_.step == SolidsStep::linear)
      error("coupled.step", {1, 1}, "bodies do not meet in linear steps: they go through one another",
            "leave step or $contact away: contact of $coupled stops bodies at walls and obstacles");
    if ((meets || coupled_.step == SolidsStep::energy) && !coupled_.coupling.balances_power())
      error("coupled.mode", {1, 1},
            fmt::format("mode='{}' has linear steps alone, in which {}", word_of(coupled_.coupling.mode),
                        meets ? "bodies do not meet" : "stiff bodies that turn gain energy"),
            "write mode='cut-cell', or leave it away");
    if (deck_.given("contact.friction") && deck_.given("coupled.friction"))
      error("coupled.friction", {1, 1}, "friction is given twice, here and in $contact",
            "leave it to $contact, whose friction is that of walls and obstacles, too");
    if (!energy_) return;
    unused("coupled.integrator", "it is of linear steps: these keep the energy, to order 2");
    unused("coupled.convex", "it is of linear steps");
  }
  /// Walls and obstacles hold a viscous fluid; bodies do where the deck says so.
  void friction_of_bodies() {
    if (coupled_.viscosity == 0 || !coupled_.bodies_slip || !deck_.has_group("mesh")) return;
    diagnostics_.add(deck_.remark(
        Severity::warning, "coupled.viscosity", {1, 1},
        "a viscous fluid slips along bodies: it rubs at walls and obstacles alone, bodies feel its pressure and no "
        "drag of friction",
        "bodies_slip=.false. has it stick to bodies"));
  }
  /// Checks what the deck says of bodies, which it has none of.
  void no_bodies() {
    if (deck_.has_group("mesh")) return;
    for (const AnyVariable name : Variables{"coupled.spring_on", "coupled.hinge"}) {
      for (const Subscript at : deck_.given_elements(name)) {
        error(name, at, "there is no body to hold: the deck has no $mesh", "regions of $reg and $mesh are bodies");
        break;
      }
    }
    if (coupled_.cavities_only)
      error("coupled.fluid_in", {1, 1}, "the grid is all void: no body encloses fluid, the deck has no $mesh",
            "write fluid_in='box', or add bodies");
    for (const AnyVariable name : Variables{"coupled.contact", "coupled.friction", "coupled.volume_term",
                                            "coupled.convex", "coupled.bodies_slip"})
      unused(name, "the deck has no $mesh");
    check_mesh_deck(deck_, diagnostics_);
    for (const Variable& variable : variables()) {
      if (is_of_bodies(variable)) unused_in_fluid(variable);
    }
  }

 private:
  /// Voids have a pressure of zero, as the fluid outside has it at its level: where both are, the deck says which.
  void level() {
    const bool open =
        std::count(coupled_.sides.begin(), coupled_.sides.end(), BoxSide::open) > 0 || !coupled_.openings.empty();
    if (open && coupled_.gravity_x != 0 && !coupled_.liquid)
      error("coupled.gravity_x", {1, 1}, "fluid at rest beyond open sides has no pressure that falls along x",
            "close the sides, or leave gravity_x away");
    const bool given = deck_.given("coupled.level");
    if (given && !open) unused("coupled.level", "no side is open: side(k)='open' is");
    if (given || !open || coupled_.voids.empty() || deck_.real("in.gravc") == 0) return;
    diagnostics_.add(deck_.remark(Severity::warning, "coupled.void", {1, 1},
                                  fmt::format("fluid beyond the open sides has a pressure of zero at ytop = {:.6g}, "
                                              "voids have it everywhere",
                                              coupled_.level),
                                  "level=... says where the surface of the fluid outside is; side(k)='void' has "
                                  "nothing beyond"));
  }
  static bool is_of_bodies(const Variable& variable) {
    return variable.group == "reg" || variable.group == "fem" || variable.name == "tracked_at";
  }
  void error(AnyVariable name, Subscript at, const std::string& message, const std::string& hint) {
    diagnostics_.add(deck_.remark(Severity::error, name, at, message, hint));
  }
  void unused(AnyVariable name, const std::string& hint) {
    if (!deck_.given(name) || is_default(deck_, name, {1, 1})) return;
    diagnostics_.add(deck_.remark(Severity::warning, name, {1, 1},
                                  fmt::format("{} of ${} has no effect", name, name.group()), hint));
  }
  void unused_in_fluid(const Variable& variable) {
    for (const Subscript at : deck_.given_elements(AnyVariable(variable))) {
      if (is_default(deck_, AnyVariable(variable), at)) continue;
      diagnostics_.add(
          deck_.remark(Severity::warning, AnyVariable(variable), at,
                       fmt::format("{} of ${} has no effect: there is no body", variable.name, variable.group),
                       "add $mesh, whose cells divide the regions of $reg"));
      return;
    }
  }
  void flat(AnyVariable name, Subscript at, const std::string& what) {
    error(name, at, what + ", but the box is plane", "with nz, zback and zfront it is three-dimensional");
  }
  /// Places from number `first` on are along z.
  void in_depth(AnyVariable name, int first) {
    for (const Subscript at : deck_.given_elements(name)) {
      if (at[0] >= first) return flat(name, at, fmt::format("{} {} has places along z", name, at[1]));
    }
  }

  const Deck& deck_;
  const Coupled& coupled_;
  bool energy_;
  Diagnostics& diagnostics_;
};

}  // namespace

void check_coupled_deck(const Deck& deck, const Coupled& coupled, bool energy, Diagnostics& diagnostics) {
  CoupledChecks checks(deck, coupled, energy, diagnostics);
  checks.others();
  checks.plane();
  checks.method();
  checks.step();
  checks.friction_of_bodies();
  checks.no_bodies();
}

}  // namespace tether
