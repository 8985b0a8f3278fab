// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/solids_of_deck.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "scene/axis.hpp"
#include "scene/materials.hpp"
#include "scene/rigid_of_deck.hpp"

namespace tether {
namespace {

/// The law of a region, whose numbers are told where they are out of range.
ElasticLaw law_of(const Deck& deck, int r, int dim, Diagnostics& diagnostics) {
  const auto error = [&](const char* group, const char* name, Subscript at, const std::string& message,
                         const std::string& hint) {
    diagnostics.add(deck.remark(Severity::error, group, name, at, fmt::format("region {}: {}", r, message), hint));
  };
  const std::string name = deck.text("fem", "law", r);
  const double E = deck.real("reg", "matr", 1, r), nu = deck.real("reg", "matr", 2, r);
  if (!(E > 0)) error("reg", "matr", {1, r}, fmt::format("the modulus must be > 0, not {:.6g}", E), "matr(1,r) is E");
  if (name == "fibre") return HoopFibre{E, deck.real("fem", "fibre_x", r), deck.real("fem", "fibre_y", r)};
  const int ipath = deck.given("reg", "ipath", 4, r) ? deck.integer("reg", "ipath", 4, r) : 0;
  if (ipath != 0 && ipath != 2)
    error("reg", "ipath", {4, r}, fmt::format("ipath(4) = {} is no elastic law", ipath),
          "a mesh takes 0, plane strain or space, and 2, plane stress");
  if (ipath == 2 && dim == 3)
    error("reg", "ipath", {4, r}, "plane stress has no meaning in space",
          fmt::format("write ipath(4,{})=0, the law in space, or leave z of $mesh away", r));
  const bool stress = ipath == 2;
  if (!(nu > -1) || !(nu < 0.5)) {
    error("reg", "matr", {2, r}, fmt::format("Poisson's ratio {:.6g} is out of range", nu), "-1 < nu < 0.5");
    return StVenantKirchhoff{};
  }
  const Lame l = lame(E, nu);
  if (name == "neo-hookean") {
    const std::string volumetric = deck.text("fem", "volumetric", r);
    return NeoHookean{l.lambda, l.mu,
                      volumetric == "log"      ? Volumetric::log
                      : volumetric == "square" ? Volumetric::square
                                               : Volumetric::mixed,
                      stress ? Plane::stress : Plane::strain};
  }
  const StVenantKirchhoff svk{stress ? 2 * l.lambda * l.mu / (l.lambda + 2 * l.mu) : l.lambda, l.mu};
  return name == "linear" ? ElasticLaw(LinearElastic{svk}) : ElasticLaw(svk);
}

SolidRegion region_of(const Deck& deck, int r, int dim, Diagnostics& diagnostics) {
  SolidRegion region;
  region.name = fmt::format("region {}", r);
  if (!deck.has_group("rigid")) region.law = law_of(deck, r, dim, diagnostics);
  region.velocity = {deck.real("reg", "vrx", r), deck.real("reg", "vry", r), deck.real("fem", "vrz", r)};
  for (int i = 1; i <= 3; ++i) region.spin[static_cast<std::size_t>(i - 1)] = deck.real("fem", "spin", i, r);
  if (deck.given("reg", "densir", r)) {
    region.density = deck.real("reg", "densir", r);
  } else {
    diagnostics.add(deck.remark(Severity::error, "reg", "densir", {r, 1},
                                fmt::format("region {}: densir({}) is not given", r, r),
                                "every region needs its density"));
  }
  return region;
}

Integrator integrator_of(const Deck& deck) {
  if (deck.logical("fem", "static")) return Integrator::equilibrium;
  const std::string name = deck.text("fem", "integrator");
  return name == "energy"      ? Integrator::energy
         : name == "midpoint"  ? Integrator::midpoint
         : name == "trapezoid" ? Integrator::trapezoid
                               : Integrator::central;
}

/// Nodes nearest to tracked_at.
void track_nodes(const Deck& deck, Solids& solids) {
  const auto dim = static_cast<std::size_t>(solids.mesh.dim());
  for (const Subscript at : deck.given_elements("points", "tracked_at")) {
    if (at[0] != 1 || !deck.given("points", "tracked_at", 2, at[1])) continue;
    const double place[] = {deck.real("points", "tracked_at", 1, at[1]), deck.real("points", "tracked_at", 2, at[1]),
                            deck.real("mesh", "tracked_z", at[1])};
    std::size_t nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t n = 0; n < solids.mesh.node_count(); ++n) {
      double square = 0;
      for (std::size_t i = 0; i < dim; ++i) square += std::pow(solids.mesh.x[n * dim + i] - place[i], 2);
      if (square < least) least = square, nearest = n;
    }
    solids.tracked.push_back(static_cast<int>(nearest));
  }
}

}  // namespace

/// The supports' equations on the rigid motions of each part: its rank says how many of them are left.
int free_motions(const Solids& solids) {
  const Mesh& mesh = solids.mesh;
  const int dim = mesh.dim(), motions = dim == 2 ? 3 : 6;
  const std::vector<int> part = parts_of(mesh);
  const int parts = part.empty() ? 0 : *std::max_element(part.begin(), part.end()) + 1;
  std::vector<Eigen::MatrixXd> normal(static_cast<std::size_t>(parts), Eigen::MatrixXd::Zero(motions, motions));
  for (const Support& support : solids.supports) {
    for (const int node : support.nodes) {
      const double* x = &mesh.x[static_cast<std::size_t>(node) * static_cast<std::size_t>(dim)];
      for (int i = 0; i < dim; ++i) {
        if (!support.fixed[static_cast<std::size_t>(i)]) continue;
        Eigen::VectorXd row = Eigen::VectorXd::Zero(motions);
        row[i] = 1;
        if (dim == 2) {
          row[2] = i == 0 ? -x[1] : x[0];
        } else {
          row[3 + (i + 1) % 3] = x[(i + 2) % 3], row[3 + (i + 2) % 3] = -x[(i + 1) % 3];
        }
        normal[static_cast<std::size_t>(part[static_cast<std::size_t>(node)])] += row * row.transpose();
      }
    }
  }
  int left = 0;
  for (const auto& matrix : normal) {
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(matrix);
    qr.setThreshold(1e-10);
    left = std::max(left, motions - static_cast<int>(qr.rank()));
  }
  return left;
}

void add_solids(const Deck& deck, Scene& scene, Diagnostics& diagnostics) {
  if (deck.has_group("rigid")) {
    check_rigid(deck, diagnostics);
    scene.rigid = rigid_of(deck, diagnostics);
    if (!deck.has_group("mesh")) return;
  } else if (geometry_of(deck) == Geometry::axisymmetric) {
    diagnostics.add(deck.remark(Severity::error, "in", "cyl", {1, 1}, "elastic bodies on a mesh have no axis",
                                "write cyl=0.; a ring of revolution is a mesh in space, by z of the regions in $mesh"));
  }
  auto mesh = mesh_of(deck, diagnostics);
  const int dim = mesh ? mesh->dim() : deck.given_elements("mesh", "z").empty() ? 2 : 3;
  Solids solids;
  for (int r = 1; r <= deck.integer("reg", "nreg"); ++r) solids.regions.push_back(region_of(deck, r, dim, diagnostics));
  if (!mesh) return;
  solids.mesh = std::move(*mesh);
  solids.integrator = integrator_of(deck);
  solids.alpha = deck.real("fem", "alpha"), solids.beta = deck.real("fem", "beta");
  solids.tolerance = deck.real("fem", "tolerance");
  solids.from_equilibrium = deck.logical("fem", "settle");
  add_loads(deck, solids, diagnostics);
  track_nodes(deck, solids);
  if (scene.rigid) {
    if (dim == 3) check_rigid_places(deck, *scene.rigid, solids.mesh, diagnostics);
    check_rigid_walls(deck, scene, solids.mesh, diagnostics);
  } else {
    add_supports(deck, scene, solids, diagnostics);
  }
  const bool rests = !scene.rigid && (solids.integrator == Integrator::equilibrium || solids.from_equilibrium);
  if (const int left = rests ? free_motions(solids) : 0; left > 0) {
    diagnostics.add(deck.remark(
        Severity::error, "fem", solids.from_equilibrium ? "settle" : "static", {1, 1},
        fmt::format("the supports leave {} rigid motion{} free: there is no equilibrium", left, left > 1 ? "s" : ""),
        "hold more by fix_on and fix, or by a wall that the body stands at"));
  }
  scene.solids = std::make_shared<const Solids>(std::move(solids));
}

}  // namespace tether
