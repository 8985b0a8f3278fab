// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <utility>

#include "deck/spelling.hpp"
#include "read/mesh/grid_edges.hpp"
#include "read/mesh/rigid_of_deck.hpp"
#include "read/points/axis.hpp"

namespace tether {
namespace {

class RigidChecks {
 public:
  RigidChecks(const Deck& deck, Diagnostics& diagnostics) : deck_(deck), diagnostics_(diagnostics) {}

  void mesh() {
    if (!deck_.has_group("mesh")) {
      error("rigid", "", {1, 1}, "a rigid body needs a mesh, which gives it its mass and its shape",
            "add $mesh, and the blocks of it as regions of $reg");
    }
    if (geometry_of(deck_) == Geometry::axisymmetric)
      error("in", "cyl", {1, 1}, "a rigid body moves in space: it has no axis", "write cyl=0.");
  }
  void statics() {
    for (const char* name : {"static", "settle"}) {
      if (deck_.logical("fem", name))
        error("fem", name, {1, 1}, "a rigid body has no equilibrium to look for: loads move it", "leave it away");
    }
  }
  void integrator() {
    const std::string name = deck_.text("fem", "integrator");
    if (name == "energy" || name == "midpoint") return;
    error("fem", "integrator", {1, 1}, fmt::format("a rigid body has no steps by '{}'", name),
          "leave it away: the mid-point rule keeps energy and momenta of a rigid body");
  }
  void supports() {
    for (const Subscript at : deck_.given_elements("fem", "fix_on")) {
      error("fem", "fix_on", at, "a rigid body has no supports at its nodes",
            "hold one place of it by pin of $rigid, or leave it away");
    }
  }
  void damping() {
    for (const char* name : {"alpha", "beta"}) {
      if (deck_.real("fem", name) != 0)
        error("fem", name, {1, 1}, "a rigid body has no damping", fmt::format("write {}=0.", name));
    }
  }
  void spin() {
    for (const Subscript at : deck_.given_elements("fem", "spin")) {
      if (deck_.real("fem", "spin", at[0], at[1]) == 0) continue;
      return error("fem", "spin", at, fmt::format("region {} does not turn alone: it is part of a rigid body", at[1]),
                   "give the body's angular velocity by omega of $rigid");
    }
  }
  void warn_of_what_has_no_effect() {
    for (const char* name : {"tolerance", "cfl"}) {
      const bool plain = value_text(deck_.value("fem", name)) == find_variable("fem", name)->fallback;
      if (plain || !deck_.given("fem", name)) continue;
      diagnostics_.add(deck_.remark(Severity::warning, "fem", name, {1, 1},
                                    fmt::format("{} of $fem has no effect on a rigid body", name)));
    }
  }

 private:
  void error(const char* group, const char* name, Subscript at, const std::string& message, const std::string& hint) {
    diagnostics_.add(deck_.remark(Severity::error, group, name, at, message, hint));
  }
  const Deck& deck_;
  Diagnostics& diagnostics_;
};

}  // namespace

void check_rigid(const Deck& deck, Diagnostics& diagnostics) {
  RigidChecks checks(deck, diagnostics);
  checks.mesh();
  checks.statics();
  checks.integrator();
  checks.supports();
  checks.damping();
  checks.spin();
  checks.warn_of_what_has_no_effect();
}

void check_rigid_places(const Deck& deck, const Rigid& rigid, const Mesh& mesh, Diagnostics& diagnostics) {
  if (mesh.dim() == 2) {
    const bool of_file = !deck.text("mesh", "file").empty();
    return diagnostics.add(deck.remark(Severity::error, "mesh", of_file ? "file" : "", {1, 1},
                                       "a rigid body moves in space, and this mesh is plane",
                                       of_file ? "give a file with tetrahedra or hexahedra"
                                               : "give z(1:2,r), the lowest and the highest z of each region r"));
  }
  constexpr double farthest = 1e4;  // its square leaves half of the digits to the body's own moments
  const Eigen::Map<const Eigen::Matrix3Xd> x(mesh.x.data(), 3, static_cast<Eigen::Index>(mesh.node_count()));
  const Eigen::Vector3d low = x.rowwise().minCoeff(), high = x.rowwise().maxCoeff();
  for (const auto& [name, place] : {std::pair("point", rigid.point), std::pair("pin", rigid.pin)}) {
    if (!place) continue;
    const double times = (*place - (low + high) / 2).norm() / (high - low).norm();
    if (times <= farthest) continue;
    diagnostics.add(
        deck.remark(Severity::error, "rigid", name, {1, 1},
                    fmt::format("the {} is {:.3g} times the body's size away from it", name, times),
                    fmt::format("place it nearer: from {:.0e} sizes on inertia is lost in rounding", farthest)));
  }
}

void check_rigid_walls(const Deck& deck, const Scene& scene, const Mesh& mesh, Diagnostics& diagnostics) {
  for (const GridEdge& edge : edges_of(scene)) {
    if (edge.wall == Wall::open) continue;
    const std::size_t nodes = nodes_at(mesh, edge).size();
    if (nodes == 0) continue;
    diagnostics.add(deck.remark(
        Severity::error, "in", edge.variable, {1, 1},
        fmt::format("{} nodes of the rigid body stand at the edge of the grid, and its wall {} = {} would hold them",
                    nodes, edge.variable, static_cast<int>(edge.wall)),
        fmt::format("write {}=1, or place the edge elsewhere; pin of $rigid holds one place of the body",
                    edge.variable)));
  }
}

}  // namespace tether
