// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/box/checks.hpp"

#include <fmt/format.h>

#include <cmath>

#include "read/memory.hpp"
#include "read/points/axis.hpp"
#include "read/regions_of_deck.hpp"

namespace tether {
namespace {

/// Tells of what a scene cannot be made of.
class Frame {
 public:
  Frame(const Deck& deck, Diagnostics& diagnostics)
      : deck_(deck), diagnostics_(diagnostics), space_(deck.given("coupled", "nz")) {}

  bool check() {
    groups();
    depth();
    cells();
    if (deck_.has_group("mesh")) mesh();
    if (good_) memory();
    return good_;
  }

 private:
  void no(const char* group, const char* name, Subscript at, const std::string& message, const std::string& hint) {
    diagnostics_.add(deck_.remark(Severity::error, group, name, at, message, hint));
    good_ = false;
  }
  void groups() {
    if (deck_.has_group("flow")) {
      no("flow", "", {1, 1}, "$flow stands beside $coupled", "a deck has one fluid: by $flow on a mesh, or in the box");
    } else if (has_flow(deck_)) {
      no("fem", "law", {regions_of(deck_, true)[0], 1}, "a region of $reg is a fluid beside $coupled",
         "$coupled describes the fluid, regions are solids");
    }
    if (deck_.has_group("rigid"))
      no("rigid", "", {1, 1}, "rigid bodies in a fluid are not modelled", "leave $rigid away: elastic bodies are");
    if (geometry_of(deck_) == Geometry::axisymmetric)
      no("in", "cyl", {1, 1}, "a fluid in a box has no axis", "write cyl=0.");
  }
  void depth() {
    for (const char* end : {"zback", "zfront"}) {
      if (deck_.given("coupled", end) == space_) continue;
      const char* there = space_ ? "nz" : end;
      no("coupled", there, {1, 1}, fmt::format("{} is not given, but {} is", space_ ? end : "nz", there),
         "a box in space has nz, zback and zfront; in the plane leave them away");
      return;
    }
    if (!space_) return;
    const double low = deck_.real("coupled", "zback"), high = deck_.real("coupled", "zfront");
    const double size = (high - low) / (deck_.integer("coupled", "nz") - 1);
    if (high > low && std::isfinite(size) && std::isfinite(1 / size) && low + size > low && high - size < high) return;
    no("coupled", "zfront", {1, 1}, fmt::format("zfront = {:.6g} is not above zback = {:.6g}", high, low),
       "the nodes would coincide");
  }
  void cells() {
    const auto few = [&](const char* group, const char* name) {
      if (deck_.integer(group, name) < 3)
        no(group, name, {1, 1}, "the box has fewer than 2 cells along an axis",
           fmt::format("{} counts nodes: write 3 or more", name));
    };
    few("in", "nx"), few("in", "ny");
    if (space_) few("coupled", "nz");
  }
  void memory() {
    StaggeredGrid grid;
    grid.n = {deck_.integer("in", "nx") - 1, deck_.integer("in", "ny") - 1,
              space_ ? deck_.integer("coupled", "nz") - 1 : 1};
    const std::string too_large = memory_refusal(grid);
    if (!too_large.empty()) no(space_ ? "coupled" : "in", space_ ? "nz" : "nx", {1, 1}, too_large, "use fewer nodes");
  }
  void mesh() {
    const auto z = deck_.given_elements("mesh", "z");
    if (deck_.text("mesh", "file").empty()) {
      const std::string element = deck_.given("mesh", "element") ? deck_.text("mesh", "element") : "q1";
      if (element != "p1")
        no("mesh", "element", {1, 1}, fmt::format("bodies in the fluid are not made of elements '{}'", element),
           "write element='p1' in $mesh: triangles, in space tetrahedra");
      if (!space_ && !z.empty())
        no("mesh", "z", z[0], "the mesh is three-dimensional, but the box is plane",
           "give nz, zback and zfront of $coupled, or leave z away");
      if (space_ && z.empty())
        no("coupled", "nz", {1, 1}, "the box is three-dimensional, but the mesh is plane",
           "give z of the regions in $mesh, or leave nz, zback and zfront away");
    }
  }

  const Deck& deck_;
  Diagnostics& diagnostics_;
  bool space_, good_ = true;
};

}  // namespace

bool check_coupled_frame(const Deck& deck, Diagnostics& diagnostics) { return Frame(deck, diagnostics).check(); }

}  // namespace tether
