// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/mesh/rigid.hpp"

#include <fmt/format.h>
#include <cmath>
#include <set>
#include <utility>

#include "deck/elements.hpp"
#include "deck/spelling.hpp"
#include "read/mesh/sides.hpp"
#include "read/points/geometry.hpp"
#include "read/values.hpp"

namespace tether {
namespace {

/// Reads $rigid and reports what is wrong with it.
class RigidReader {
 public:
  RigidReader(const Deck& deck, Diagnostics& diagnostics) : deck_(deck), diagnostics_(diagnostics) {}

  Rigid read() {
    Rigid rigid;
    rigid.form = word<RigidForm>(deck_, "rigid.form");
    rigid.point = place("rigid.point"), rigid.pin = place("rigid.pin");
    rigid.directors = directors();
    rigid.omega = components("rigid.omega", 1);
    rigid.velocity = velocity(rigid.pin.has_value());
    for (const int k :
         numbers("rigid.torque", {"rigid.torque_time", "rigid.torque_factor", "rigid.torque_expression"})) {
      rigid.torques.push_back({components("rigid.torque", k), amplitude_of(deck_, "rigid.torque", k, diagnostics_)});
    }
    for (const int k : numbers("rigid.force", {"rigid.force_at", "rigid.force_time", "rigid.force_factor",
                                               "rigid.force_expression", "rigid.turning"}))
      rigid.forces.push_back(force(k));
    return rigid;
  }

 private:
  void error(AnyVariable name, Subscript at, const std::string& message, const std::string& hint) {
    diagnostics_.add(deck_.remark(Severity::error, name, at, message, hint));
  }
  Eigen::Vector3d components(RealVariable name, int k) const {
    return {deck_.real(name, 1, k), deck_.real(name, 2, k), deck_.real(name, 3, k)};
  }
  /// All three components, or none.
  std::optional<Eigen::Vector3d> place(RealVariable name, int k = 1) {
    int given = 0, last = 1;
    for (int i = 1; i <= 3; ++i) {
      if (deck_.given(name, i, k)) ++given, last = i;
    }
    if (given == 3) return components(name, k);
    if (given > 0) {
      const std::string what = name == "rigid.directors" ? fmt::format("director {}", k) : std::string(name.name());
      error(name, {last, k}, fmt::format("{} has {} of its three components", what, given), "give x, y and z of it");
    }
    return std::nullopt;
  }
  Eigen::Matrix3d directors() {
    Eigen::Matrix3d directors = Eigen::Matrix3d::Identity();
    for (int k = 1; k <= 3; ++k) {
      if (const auto given = place("rigid.directors", k)) directors.col(k - 1) = *given;
    }
    for (int k = 1; k <= 3; ++k) {
      const double length = directors.col(k - 1).norm();
      if (std::isfinite(length) && length > 0) continue;
      error("rigid.directors", {1, k}, fmt::format("director {} has length {}", k, length),
            "give three independent directions, neither 0 nor beyond all numbers");
      return Eigen::Matrix3d::Identity();
    }
    const double volume = spanned_volume(directors);
    if (volume >= least_spanned_volume) return directors;
    const auto first = deck_.given_elements("rigid.directors").front();  // the unit vectors span 1
    error("rigid.directors", first, fmt::format("the directors lie in one plane: their directions span {:.3g}", volume),
          "give three independent directions; they need not be orthogonal");
    return Eigen::Matrix3d::Identity();
  }
  /// Returns the velocity of the centre of mass: that of all regions.
  Eigen::Vector3d velocity(bool pinned) {
    constexpr std::array<RealVariable, 3> names{"reg.vrx", "reg.vry", "fem.vrz"};
    Eigen::Vector3d first;
    for (int i = 0; i < 3; ++i) {
      const RealVariable name = names[static_cast<std::size_t>(i)];
      first[i] = deck_.real(name, 1);
      for (const int r : regions_of(deck_)) {
        const double v = deck_.real(name, r);
        if (v == first[i]) continue;
        error(name, {r, 1},
              fmt::format("region {} moves with {} = {:.6g}, region 1 with {:.6g}: they are one rigid body", r, name, v,
                          first[i]),
              "give all regions one velocity, that of the body's centre of mass; omega of $rigid turns it");
        break;
      }
      if (pinned && first[i] != 0) {
        error(name, {1, 1}, fmt::format("a pin holds the body, which cannot move with {} = {:.6g}", name, first[i]),
              "leave it away: omega of $rigid says how the body begins to turn about the pin");
      }
    }
    return pinned ? Eigen::Vector3d::Zero() : first;
  }
  /// Numbers k of the torques or forces that are given; reports tables and places that belong to none.
  std::set<int> numbers(AnyVariable name, Variables with) {
    std::set<int> given, told;
    for (const Subscript at : deck_.given_elements(name)) given.insert(at[1]);
    for (const AnyVariable other : with) {
      const Variable& variable = other.row();
      for (const Subscript at : deck_.given_elements(other)) {
        const int k = at[static_cast<std::size_t>(variable.rank - 1)];
        if (given.count(k) > 0 || !told.insert(k).second) continue;
        error(other, at, fmt::format("{} belongs to no {}", element_name(variable, at), name),
              fmt::format("give {}(1:3,{})", name, k));
      }
    }
    return given;
  }
  RigidForce force(int k) {
    RigidForce force;
    force.force = components("rigid.force", k);
    force.turning = deck_.logical("rigid.turning", k);
    force.amplitude = amplitude_of(deck_, "rigid.force", k, diagnostics_);
    const std::size_t errors = diagnostics_.errors().size();
    if (const auto at = place("rigid.force_at", k)) {
      force.at = *at;
    } else if (diagnostics_.errors().size() == errors) {
      error("rigid.force", {1, k}, fmt::format("force {} has no place", k), fmt::format("give force_at(1:3,{})", k));
    }
    return force;
  }

  const Deck& deck_;
  Diagnostics& diagnostics_;
};

}  // namespace

std::shared_ptr<const Rigid> rigid_of(const Deck& deck, Diagnostics& diagnostics) {
  return std::make_shared<const Rigid>(RigidReader(deck, diagnostics).read());
}

namespace {

class RigidChecks {
 public:
  RigidChecks(const Deck& deck, Diagnostics& diagnostics) : deck_(deck), diagnostics_(diagnostics) {}

  void mesh() {
    if (!deck_.has_group("mesh")) {
      diagnostics_.add(deck_.remark_on_group(Severity::error, "rigid",
                                             "a rigid body needs a mesh, which gives it its mass and its shape",
                                             "add $mesh, and the blocks of it as regions of $reg"));
    }
    if (geometry_of(deck_) == Geometry::axisymmetric)
      error("in.cyl", {1, 1}, "a rigid body moves in space: it has no axis", "write cyl=0.");
  }
  void statics() {
    for (const AnyVariable name : Variables{"fem.static", "fem.settle"}) {
      if (deck_.logical(name))
        error(name, {1, 1}, "a rigid body has no equilibrium to look for: loads move it", "leave it away");
    }
  }
  void integrator() {
    const std::string name = deck_.text("fem.integrator");
    if (name == "energy" || name == "midpoint") return;
    error("fem.integrator", {1, 1}, fmt::format("a rigid body has no steps by '{}'", name),
          "leave it away: the mid-point rule keeps energy and momenta of a rigid body");
  }
  void supports() {
    for (const Subscript at : deck_.given_elements("fem.fix_on")) {
      error("fem.fix_on", at, "a rigid body has no supports at its nodes",
            "hold one place of it by pin of $rigid, or leave it away");
    }
  }
  void damping() {
    for (const AnyVariable name : Variables{"fem.alpha", "fem.beta"}) {
      if (deck_.real(name) != 0) error(name, {1, 1}, "a rigid body has no damping", fmt::format("write {}=0.", name));
    }
  }
  void spin() {
    for (const Subscript at : deck_.given_elements("fem.spin")) {
      if (deck_.real("fem.spin", at[0], at[1]) == 0) continue;
      return error("fem.spin", at, fmt::format("region {} does not turn alone: it is part of a rigid body", at[1]),
                   "give the body's angular velocity by omega of $rigid");
    }
  }
  void warn_of_what_has_no_effect() {
    for (const AnyVariable name : Variables{"fem.tolerance", "fem.cfl"}) {
      const bool plain = is_default(deck_, name, {1, 1});
      if (plain || !deck_.given(name)) continue;
      diagnostics_.add(
          deck_.remark(Severity::warning, name, {1, 1}, fmt::format("{} of $fem has no effect on a rigid body", name)));
    }
  }

 private:
  void error(AnyVariable name, Subscript at, const std::string& message, const std::string& hint) {
    diagnostics_.add(deck_.remark(Severity::error, name, at, message, hint));
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
    constexpr const char* plane = "a rigid body moves in space, and this mesh is plane";
    return diagnostics.add(
        deck.text("mesh.file").empty()
            ? deck.remark_on_group(Severity::error, "mesh", plane,
                                   "give z(1:2,r), the lowest and the highest z of each region r")
            : deck.remark(Severity::error, "mesh.file", {1, 1}, plane, "give a file with tetrahedra or hexahedra"));
  }
  constexpr double farthest = 1e4;  // its square leaves half of the digits to the body's own moments
  const Eigen::Map<const Eigen::Matrix3Xd> x(mesh.x.data(), 3, static_cast<Eigen::Index>(mesh.node_count()));
  const Eigen::Vector3d low = x.rowwise().minCoeff(), high = x.rowwise().maxCoeff();
  for (const auto& [name, place] :
       {std::pair(AnyVariable("rigid.point"), rigid.point), std::pair(AnyVariable("rigid.pin"), rigid.pin)}) {
    if (!place) continue;
    const double times = (*place - (low + high) / 2).norm() / (high - low).norm();
    if (times <= farthest) continue;
    diagnostics.add(deck.remark(
        Severity::error, name, {1, 1}, fmt::format("the {} is {:.3g} times the body's size away from it", name, times),
        fmt::format("place it nearer: from {:.0e} sizes on inertia is lost in rounding", farthest)));
  }
}

void check_rigid_walls(const Deck& deck, const Scene& scene, const Mesh& mesh, Diagnostics& diagnostics) {
  for (const GridEdge& edge : edges_of(scene)) {
    if (edge.wall == Wall::open) continue;
    const std::size_t nodes = nodes_at(mesh, edge).size();
    if (nodes == 0) continue;
    diagnostics.add(deck.remark(
        Severity::error, edge.variable, {1, 1},
        fmt::format("{} nodes of the rigid body stand at the edge of the grid, and its wall {} = {} would hold them",
                    nodes, edge.variable, static_cast<int>(edge.wall)),
        fmt::format("write {}=1, or place the edge elsewhere; pin of $rigid holds one place of the body",
                    edge.variable)));
  }
}

}  // namespace tether
