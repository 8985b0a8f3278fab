// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "grid/block_mesh.hpp"
#include "physics/solids/make_elements.hpp"
#include "physics/solids/step.hpp"
#include "unit/alone.hpp"
#include "unit/physics/solids/blocks_support.hpp"

namespace tether::fem {
namespace {

using namespace support;

/// Patch test: whatever constant stretch the boundary has, the inner nodes follow it, and the stress is the law's.
TEST(Solids, PatchOfNeoHookeanElementsTakesAConstantStretch) {
  for (const Element& element : all_elements()) {
    SCOPED_TRACE(element);
    Solids solids = skew_block(element, neo_hookean());
    Eigen::Matrix3d F;
    F << 1.12, 0.08, 0, -0.05, 0.95, 0, 0, 0, 1;
    if (solids.mesh.dim() == 3) F(0, 2) = 0.05, F(2, 2) = 1.04;
    const std::vector<double> exact = mapped(solids.mesh, F);
    solids.integrator = Integrator::equilibrium;
    const Sides boundary = boundary_of(solids.mesh);
    const auto dim = static_cast<std::size_t>(solids.mesh.dim());
    for (const int node : boundary) {
      Support support{{node}, {true, true, dim == 3}, {}, {}};
      for (std::size_t i = 0; i < dim; ++i) {
        const std::size_t k = static_cast<std::size_t>(node) * dim + i;
        support.displacement[i] = exact[k] - solids.mesh.x[k];
      }
      solids.supports.push_back(support);
    }
    const SolidSystem system(solids, 0, alone());
    SolidStep step(system);
    SolidState state;
    state.q = exact, state.v.assign(state.q.size(), 0.0);
    const std::vector<double> off = shaken(solids.mesh, 6, 0.03);
    for (std::size_t k = 0; k < exact.size(); ++k) state.q[k] += off[k] - solids.mesh.x[k];
    ASSERT_TRUE(step.settle(state).converged);
    for (std::size_t k = 0; k < exact.size(); ++k) EXPECT_NEAR(state.q[k], exact[k], 1e-10);
  }
}

TEST(Solids, TurnedBodiesFeelNothing) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(2.2, Eigen::Vector3d(0, 0, 1)).toRotationMatrix();
  for (const Element& element : all_elements()) {
    for (const ElasticLaw& law : {neo_hookean(), ElasticLaw(StVenantKirchhoff{2, 1.3})}) {
      const Solids solids = skew_block(element, law);
      const auto elements = make_elements(solids, alone());
      const std::vector<double> q = mapped(solids.mesh, turn);
      std::vector<double> f(q.size(), 0.0);
      elements->add_forces(StressAt::end, q, q, f);
      for (const double force : f) EXPECT_NEAR(force, 0, 1e-13);
      EXPECT_NEAR(elements->strain_energy(q), 0, 1e-13);
    }
  }
}

/// A free bar of neo-Hookean material under tension: across it S = 0, along it sigma = mu (a^2 - b^2)/J with
/// mu (b^2 - 1) + lambda ln J = 0, J = a b^2; held in z, J = a b.
void expect_pulled(const Element& element) {
  const double lambda = 2, mu = 1.3, a = 1.6;
  const std::size_t dim = static_cast<std::size_t>(dimension_of(element.kind));
  double low = 0.3, high = 1;
  for (int k = 0; k < 200; ++k) {
    const double b = 0.5 * (low + high);
    (mu * (b * b - 1) + lambda * std::log(dim == 3 ? a * b * b : a * b) > 0 ? high : low) = b;
  }
  const double b = low, force = mu * (a - b * b / a);  // P = sigma b^2: per area of the shape at the start
  Block block;
  block.edges = {straight({0, 0}, {2, 0}), straight({2, 0}, {2, 1}), straight({2, 1}, {0, 1}),
                 straight({0, 1}, {0, 0})};
  block.cells = {2, 1, 1}, block.z_high = 1;
  std::vector<MeshFlaw> flaws;
  Solids solids;
  solids.mesh = mesh_of_blocks({block}, element.kind, flaws);
  solids.dilatation = element.dilatation;
  solids.regions = {{"bar", neo_hookean(), 1, {}, {}}};
  solids.integrator = Integrator::equilibrium;
  for (const auto& [side, axis] : {std::pair("1.left", 0), std::pair("1.bottom", 1), std::pair("1.back", 2)}) {
    if (axis == 2 && dim == 2) continue;
    Support support{solids.mesh.sides.at(side), {}, {}, {}};
    support.fixed[static_cast<std::size_t>(axis)] = true;
    solids.supports.push_back(support);
  }
  Load load{.sides = solids.mesh.sides.at("1.right"), .nodes = {}, .force = {force, 0, 0}, .amplitude = {}};
  solids.loads.push_back(std::move(load));
  const SolidSystem system(solids, 0, alone());
  SolidStep step(system);
  SolidState state;
  state.q = solids.mesh.x, state.v.assign(state.q.size(), 0.0);
  ASSERT_TRUE(step.settle(state).converged);
  for (std::size_t n = 0; n < solids.mesh.node_count(); ++n) {
    EXPECT_NEAR(state.q[dim * n], a * solids.mesh.x[dim * n], 1e-10);
    EXPECT_NEAR(state.q[dim * n + 1], b * solids.mesh.x[dim * n + 1], 1e-10);
  }
}

TEST(Solids, PulledBarMeetsTheClosedForm) {
  for (const Element& element : all_elements()) {
    SCOPED_TRACE(element);
    expect_pulled(element);
  }
}

/// The forces of the discrete gradient do the work that the energies differ by, and have no resultant and no torque
/// about the middle of the step, however far it goes.
TEST(Solids, TheDiscreteGradientKeepsEnergyAndMomenta) {
  for (const Element& element : all_elements()) {
    for (const ElasticLaw& law :
         {neo_hookean(), ElasticLaw(NeoHookean{90, 1.3, Volumetric::mixed, Plane::strain}),
          ElasticLaw(NeoHookean{90, 1.3, Volumetric::square, Plane::strain}), ElasticLaw(StVenantKirchhoff{2, 1.3})}) {
      const Solids solids = skew_block(element, law);
      const auto elements = make_elements(solids, alone());
      const std::vector<double> q0 = shaken(solids.mesh, 4, 0.04), q1 = shaken(solids.mesh, 5, 0.04);
      std::vector<double> f(q0.size(), 0.0);
      elements->add_forces(StressAt::gradient, q0, q1, f);
      double work = 0, torque = 0, size = 0;
      const auto dim = static_cast<std::size_t>(solids.mesh.dim());
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (std::size_t k = 0; k < f.size(); ++k) {
        work += f[k] * (q1[k] - q0[k]), size += std::abs(f[k]);
        sum[static_cast<int>(k % dim)] += f[k];
      }
      for (std::size_t n = 0; n < solids.mesh.node_count(); ++n) {
        const std::size_t k = n * dim;
        torque += 0.5 * ((q0[k] + q1[k]) * f[k + 1] - (q0[k + 1] + q1[k + 1]) * f[k]);
      }
      const double difference = elements->strain_energy(q1) - elements->strain_energy(q0);
      EXPECT_NEAR(work, difference, 1e-12 * size) << element << " " << law.index();
      EXPECT_NEAR(torque, 0, 1e-12 * size) << element;
      EXPECT_NEAR(sum.norm(), 0, 1e-12 * size) << element;
    }
  }
}

/// Tangents of all rules and laws against central differences of the forces.
TEST(Solids, TangentIsTheDerivativeOfTheForces) {
  constexpr double h = 1e-6;
  for (const Element& element : all_elements()) {
    for (const ElasticLaw& law : {neo_hookean(), ElasticLaw(StVenantKirchhoff{2, 1.3}),
                                  ElasticLaw(LinearElastic{{2, 1.3}}), ElasticLaw(HoopFibre{1.5, -3, -4})}) {
      const Solids solids = skew_block(element, law, {1, 1, 1});
      const auto elements = make_elements(solids, alone());
      const NodalPattern pattern(solids.mesh.dim(), solids.mesh.node_count(), solids.mesh.nodes,
                                 node_count_of(element.kind));
      const std::vector<double> q0 = shaken(solids.mesh, 1, 0.04), q1 = shaken(solids.mesh, 2, 0.04);
      for (const StressAt rule : {StressAt::gradient, StressAt::middle, StressAt::end}) {
        SparseMatrix K = pattern.matrix();
        elements->add_tangent(rule, q0, q1, 0, pattern, K);
        double largest = 0, worst = 0;
        for (const double value : K.value) largest = std::max(largest, std::abs(value));
        for (std::size_t j = 0; j < q1.size(); j += 3) {
          std::vector<double> up = q1, down = q1, high(q1.size(), 0.0), low(q1.size(), 0.0);
          up[j] += h, down[j] -= h;
          elements->add_forces(rule, q0, up, high), elements->add_forces(rule, q0, down, low);
          for (auto k = static_cast<std::size_t>(K.start[j]); k < static_cast<std::size_t>(K.start[j + 1]); ++k) {
            const auto i = static_cast<std::size_t>(K.row[k]);
            worst = std::max(worst, std::abs(K.value[k] - (high[i] - low[i]) / (2 * h)));
          }
        }
        EXPECT_LT(worst, 1e-6 * largest) << element << " " << law.index() << " " << static_cast<int>(rule);
      }
    }
  }
}

/// Newton's method squares the error with every iteration: of three residuals above rounding r2/r1 is (r1/r0)^2 but for
/// a factor of order one.
TEST(Solids, NewtonsMethodIsQuadratic) {
  for (const Integrator integrator : {Integrator::energy, Integrator::midpoint, Integrator::trapezoid}) {
    for (const auto& [law, dilatation] : {std::pair(neo_hookean(), Dilatation::mean),
                                          std::pair(ElasticLaw(StVenantKirchhoff{2, 1.3}), Dilatation::point)}) {
      Solids solids = skew_block({ElementKind::hex8, dilatation}, law);
      solids.integrator = integrator;
      const SolidSystem system(solids, 0, alone());
      SolidStep step(system);
      SolidState state;
      state.q = shaken(solids.mesh, 3, 0.02), state.v.assign(state.q.size(), 0.0);
      const NewtonReport report = step.advance(state, 0.3);
      ASSERT_TRUE(report.converged);
      const auto& r = report.residuals;
      const auto last = static_cast<std::size_t>(
          std::find_if(r.begin(), r.end(), [](double size) { return size < 1e-10; }) - r.begin());
      ASSERT_GT(last, 2U);
      EXPECT_GT(std::log(r[last - 1] / r[last - 2]) / std::log(r[last - 2] / r[last - 3]), 1.7)
          << static_cast<int>(integrator) << " " << law.index();
    }
  }
}

/// Lowest frequency of a bar of length 1 between a clamp and a free end that only stretches: pi/2 with E = rho = 1.
double bar_frequency(ElementKind kind, int cells) {
  Block block;
  block.edges = {straight({0, 0}, {1, 0}), straight({1, 0}, {1, 0.1}), straight({1, 0.1}, {0, 0.1}),
                 straight({0, 0.1}, {0, 0})};
  block.cells = {cells, 1, 1};
  std::vector<MeshFlaw> flaws;
  Solids solids;
  solids.mesh = mesh_of_blocks({block}, kind, flaws);
  solids.regions = {{"bar", LinearElastic{{0, 0.5}}, 1, {}, {}}};  // nu = 0
  Support clamp{solids.mesh.sides.at("1.left"), {true, true, false}, {}, {}};
  Support along;
  for (std::size_t n = 0; n < solids.mesh.node_count(); ++n) along.nodes.push_back(static_cast<int>(n));
  along.fixed = {false, true, false};
  solids.supports = {clamp, along};
  const SolidSystem system(solids, 0, alone());
  SparseMatrix K = system.pattern.matrix();
  system.elements->add_tangent(StressAt::end, solids.mesh.x, solids.mesh.x, 0, system.pattern, K);
  hold(K, system.held, 1);
  SparseSolver solver;
  EXPECT_TRUE(solver.factorise(K, Definite::positive));
  std::vector<double> v(system.unknowns(), 1.0), Mv(v.size());
  double eigenvalue = 0;
  for (int k = 0; k < 60; ++k) {  // inverse iteration
    for (std::size_t i = 0; i < v.size(); ++i) v[i] = system.held[i] ? 0 : v[i];
    system.multiply_mass(v, Mv);
    double size = 0;
    for (std::size_t i = 0; i < v.size(); ++i) size += v[i] * Mv[i];
    for (std::size_t i = 0; i < v.size(); ++i) Mv[i] = system.held[i] ? 0 : Mv[i] / std::sqrt(size);
    std::vector<double> next(v.size());
    solver.solve(Mv, next);
    double product = 0;
    for (std::size_t i = 0; i < v.size(); ++i) product += next[i] * Mv[i];
    eigenvalue = 1 / product;
    v = next;
  }
  return std::sqrt(eigenvalue);
}

TEST(Solids, FrequenciesOfABarAreOfOrderTwoAndFour) {
  const double exact = std::numbers::pi / 2;
  for (const auto& [kind, order] :
       {std::pair(ElementKind::quad4, 2.0), std::pair(ElementKind::quad9, 4.0), std::pair(ElementKind::tri6, 4.0)}) {
    const double coarse = bar_frequency(kind, 4) / exact - 1, fine = bar_frequency(kind, 8) / exact - 1;
    EXPECT_LT(std::abs(fine), 0.005);
    EXPECT_NEAR(std::log2(coarse / fine), order, 0.2);
  }
}

/// A body moves and spins at the start as the deck says, at every node, by lumped masses and by consistent ones.
TEST(Solids, StartAsTheyAreThrown) {
  for (const Element& element : all_elements()) {
    for (const Integrator integrator : {Integrator::energy, Integrator::central}) {
      SCOPED_TRACE(element);
      Solids solids = skew_block(element, neo_hookean());
      solids.integrator = integrator;
      solids.regions[0].velocity = {3, -1, 0}, solids.regions[0].spin = {0, 0, 2};
      const SolidSystem system(solids, 0, alone());
      const std::vector<double> v = first_velocities(system);
      const auto dim = static_cast<std::size_t>(solids.mesh.dim());
      // Velocities of a body that turns about any place differ by what their places do.
      for (std::size_t n = 0; n < solids.mesh.node_count(); ++n) {
        EXPECT_NEAR(v[n * dim] - v[0], -2 * (solids.mesh.x[n * dim + 1] - solids.mesh.x[1]), 1e-12);
        EXPECT_NEAR(v[n * dim + 1] - v[1], 2 * (solids.mesh.x[n * dim] - solids.mesh.x[0]), 1e-12);
      }
      double mass = 0, momentum = 0;
      for (std::size_t n = 0; n < solids.mesh.node_count(); ++n)
        mass += system.region_weights[0][n], momentum += system.region_weights[0][n] * v[n * dim];
      EXPECT_NEAR(momentum, 3 * mass, 1e-12);
      EXPECT_NEAR(mass, std::accumulate(system.lumped.begin(), system.lumped.end(), 0.0), 1e-12);
    }
  }
}

TEST(Solids, MassesAndLoadsAddUp) {
  for (const Element& element : all_elements()) {
    const Solids solids = skew_block(element, neo_hookean());
    const auto elements = make_elements(solids, alone());
    const double area = 0.5 * ((2 * 1.4 - 2.2 * 0.3) + (2.2 * 1 + 0.2 * 1.4));  // by the shoelace formula
    const double volume = area * (solids.mesh.dim() == 3 ? 1.1 : 1);
    double lumped = 0, nodal = 0;
    for (const double m : elements->lumped_volumes(0)) {
      EXPECT_GT(m, 0);
      lumped += m;
    }
    for (const double m : elements->lumped_volumes(1)) EXPECT_EQ(m, 0);
    for (const double v : elements->volumes(0)) nodal += v;
    EXPECT_NEAR(lumped, volume, 1e-12);
    EXPECT_NEAR(nodal, volume, 1e-12);
  }
}

}  // namespace
}  // namespace tether::fem
