// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/flow/checks.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "deck/elements.hpp"
#include "deck/spelling.hpp"
#include "deck/words.hpp"
#include "read/mesh/mesh_of_file.hpp"
#include "read/values.hpp"

namespace tether {
namespace {

/// Reports what is wrong with a deck that has a fluid.
class FlowChecks {
 public:
  FlowChecks(const Deck& deck, Diagnostics& diagnostics) : deck_(deck), diagnostics_(diagnostics) {}

  bool frame() {
    const std::vector<int> fluids = regions_of(deck_, true);
    if (fluids.empty()) {
      error_of_group("flow", "no region is a fluid", "write law(r)='fluid' in $fem for the region r that is");
      return false;
    }
    bool good = true;
    const auto no = [&](AnyVariable name, Subscript at, const char* message, const char* hint) {
      error(name, at, message, hint);
      good = false;
    };
    if (deck_.has_group("rigid"))
      error_of_group("rigid", "rigid bodies in a fluid are not modelled", "leave $rigid away: elastic bodies are"),
          good = false;
    if (!deck_.has_group("mesh"))
      no("fem.law", {fluids[0], 1}, "a fluid has no mesh", "add $mesh, whose cells(1,r) divide the regions of $reg");
    if (const auto z = deck_.given_elements("mesh.z"); !z.empty())
      no("mesh.z", z[0], "a fluid is plane: its mesh has no z", "leave z away");
    return check_sources(deck_, diagnostics_) && good;
  }
  void steps() {
    const std::string name = deck_.text("fem.integrator");
    if (name != "energy" && name != "midpoint")
      error("fem.integrator", {1, 1}, fmt::format("there are no steps by '{}' beside a fluid", name),
            "immersed solids use energy or midpoint; integrator of $flow is the fluid's");
    for (const AnyVariable switched : Variables{"fem.static", "fem.settle"}) {
      if (deck_.logical(switched))
        error(switched, {1, 1}, "solids beside a fluid have no equilibrium of their own",
              "leave it away; steady of $flow looks for a steady flow");
    }
    if (word<FlowIntegrator>(deck_, "flow.integrator") == FlowIntegrator::euler &&
        !is_default(deck_, "fem.integrator", {1, 1}))
      warn("fem.integrator", {1, 1}, "integrator of $fem has no effect: the fluid uses backward Euler",
           "solids' stress is then that of each step's end; it matters beside integrator='midpoint' of $flow");
    if (!deck_.logical("flow.steady")) return;
    if (deck_.given("flow.tracers", 1))
      warn("flow.tracers", {1, 1},
           "tracers of a steady flow go through the steps that lead up to it, which take no time",
           "leave them away, or steady");
    if (!regions_of(deck_, false).empty()) resting_bodies();
    if (word<FlowIntegrator>(deck_, "flow.integrator") != FlowIntegrator::midpoint)
      warn("flow.integrator", {1, 1}, "integrator has no effect: the flow is steady", "");
  }
  void resting_bodies() {
    for (const Subscript at : deck_.given_elements("fem.fix")) {
      if (deck_.real("fem.fix", at[0], at[1]) != 0)
        error("fem.fix", at, "a support that moves has no steady flow about it: the bodies' places are found at rest",
              "write 0, or leave steady of $flow away");
    }
  }
  void solids() {
    if (!regions_of(deck_, false).empty()) return;
    for (const AnyVariable on : Variables{"fem.load_on", "fem.fix_on"}) {
      for (const Subscript at : deck_.given_elements(on))
        error(on, at, "there is no elastic body to act on: all regions are a fluid",
              "boundary_on of $flow names sides of the fluid, bx and by are its body force");
    }
    for (const Subscript at : deck_.given_elements("points.tracked_at")) {
      if (at[0] == 1)
        error("points.tracked_at", at, "there is no node to track: all regions are a fluid, whose nodes stay",
              "probe(1,k)=x,y of $flow records the flow at a place");
    }
    if (deck_.given("mesh.element"))
      warn("mesh.element", {1, 1}, "element of $mesh has no effect: all regions are a fluid",
           "element of $flow is the fluid's");
  }
  /// Scalars of $fem that mean nothing beside a fluid.
  void solver() {
    for (const AnyVariable name : Variables{"fem.alpha", "fem.beta", "fem.cfl", "fem.tolerance"}) {
      if (!deck_.given(name) || is_default(deck_, name, {1, 1})) continue;
      warn(name, {1, 1}, fmt::format("{} of $fem has no effect beside a fluid", name),
           name == "fem.tolerance" ? "tolerance of $flow counts" : "");
    }
  }
  /// Checks what is said of the fluid beyond open sides, where there is none, or no gravity that it matters in.
  void stabilisation() {
    constexpr double least = 0.1;
    const double factor = deck_.real("flow.stabilisation");
    if (word<FlowElement>(deck_, "flow.element") == FlowElement::q2q1) {
      if (factor != 1) warn("flow.stabilisation", {1, 1}, "stabilisation has no effect: q2q1 needs none", "");
    } else if (factor < least) {
      warn("flow.stabilisation", {1, 1},
           fmt::format("stabilisation = {:.6g} lets the pressure swing from node to node", factor),
           "1 is the published factor; 0.1 or less leaves pressures wrong on all but very fine meshes");
    }
  }
  void outside() {
    bool open = false;
    for (const Subscript at : deck_.given_elements("flow.boundary"))
      open |= (deck_.given("flow.boundary", at[0]) && word<Boundary>(deck_, "flow.boundary", at[0]) == Boundary::open);
    const bool acts = open && deck_.real("in.gravc") != 0;
    for (const AnyVariable name : Variables{"flow.outside", "flow.level"}) {
      const bool same = !deck_.given(name) || is_default(deck_, name, {1, 1});
      const bool of_nothing = name == "flow.level" && word<FlowOutside>(deck_, "flow.outside") == FlowOutside::nothing;
      if (!same && (!acts || of_nothing))
        warn(name, {1, 1}, fmt::format("{} of $flow has no effect", name),
             of_nothing ? "outside='void' has nothing beyond open sides" : "it is of open sides under gravc");
    }
  }
  /// Checks what a body says of its start: it starts with the fluid.
  void starts() {
    for (const int r : regions_of(deck_, false)) {
      for (const AnyVariable name : Variables{"reg.vrx", "reg.vry", "fem.vrz"}) start_of_body(name, {r, 1}, r);
      for (const int i : {1, 2, 3}) start_of_body("fem.spin", {i, r}, r);
    }
  }
  /// Checks what is said of a region that is a fluid and means solids alone, or the other way.
  void regions() {
    for (const int r : regions_of(deck_, true)) {
      check_unused("fem.volumetric", {r, 1}), check_unused("fem.vrz", {r, 1});
      check_unused("fem.spin", {1, r}), check_unused("fem.spin", {2, r}), check_unused("fem.spin", {3, r});
      check_unused("flow.penalty", {r, 1});
      if (deck_.given("reg.ipath", 4, r) && deck_.integer("reg.ipath", 4, r) != 0)
        warn("reg.ipath", {4, r}, fmt::format("ipath(4,{}) has no effect: region {} is a fluid", r, r), "");
      check_start("flow.u0", "reg.vrx", r), check_start("flow.v0", "reg.vry", r);
    }
  }

 private:
  void error(AnyVariable name, Subscript at, const std::string& message, const std::string& hint) {
    diagnostics_.add(deck_.remark(Severity::error, name, at, message, hint));
  }
  void error_of_group(const char* group, const std::string& message, const std::string& hint) {
    diagnostics_.add(deck_.remark_on_group(Severity::error, group, message, hint));
  }
  void warn(AnyVariable name, Subscript at, const std::string& message, const std::string& hint) {
    diagnostics_.add(deck_.remark(Severity::warning, name, at, message, hint));
  }
  void check_unused(AnyVariable name, Subscript at) {
    if (!deck_.given(name, at[0], at[1]) || is_default(deck_, name, at)) return;
    const Variable& variable = name.row();
    warn(name, at,
         fmt::format("{} has no effect: region {} is a fluid", element_name(variable, at),
                     variable.rank == 1 ? at[0] : at[1]),
         "");
  }
  void start_of_body(AnyVariable name, Subscript at, int r) {
    if (!deck_.given(name, at[0], at[1]) || is_default(deck_, name, at)) return;
    warn(name, at,
         fmt::format("{} has no effect: region {} starts with the fluid's velocity", element_name(name.row(), at), r),
         "u0 and v0 of $flow are the fluid's velocity at the start, and so the body's");
  }
  /// A velocity of a region that the fluid does not start with.
  void check_start(AnyVariable variable, RealVariable of_region, int r) {
    const int first = regions_of(deck_, true).front();
    const double v = deck_.real(of_region, r);
    const bool whole = deck_.given(variable);
    if (whole ? v == 0 : v == deck_.real(of_region, first)) return;
    warn(of_region, {r, 1},
         whole ? fmt::format("{}({}) has no effect: {} of $flow is there", of_region, r, variable)
               : fmt::format("{}({}) has no effect: the fluid starts as its region {} does", of_region, r, first),
         whole ? "" : fmt::format("{} of $flow is a velocity at the start that varies in place", variable));
  }

  const Deck& deck_;
  Diagnostics& diagnostics_;
};

}  // namespace

bool check_flow_frame(const Deck& deck, Diagnostics& diagnostics) { return FlowChecks(deck, diagnostics).frame(); }

void check_flow_deck(const Deck& deck, Diagnostics& diagnostics) {
  FlowChecks checks(deck, diagnostics);
  checks.steps();
  checks.solids();
  checks.solver();
  checks.stabilisation();
  checks.outside();
  checks.regions();
  checks.starts();
}

}  // namespace tether
