// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "algebra/eigen_sparse.hpp"
#include "base/vec.hpp"
#include "grid/point_finder.hpp"
#include "model/flow.hpp"
#include "model/solids.hpp"

namespace tether::fem {

/// What bodies have to know of a step: when it is [time], 1 over its length (0: steady) [1/time], the fluid's viscosity
/// [stress time], and the part of gravity and body forces that acts. In a sudden step, so short that no law answers,
/// bodies keep their volume as the fluid does: else what sets in at once would crush their surfaces.
struct PressureStep {
  double time = 0, rate = 0, viscosity = 0, loaded = 1;
  bool sudden = false;
};

/// Takes the fluid's pressure out of immersed bodies that have a law for their volume: -p div W from the momentum and q
/// div V from the continuity equation, W and V the bodies' own velocities, integrated over the bodies' shape. Such a
/// body changes its volume by its own law, which with the pressure inside (55) it does on coarse meshes alone: div v =
/// 0 comes into force in it as the fluid's cells shrink. Both terms are one matrix and its transpose, so that what the
/// pressure does to the fluid and to the body is one power.
///
/// Inside of bodies the pressure goes on smoothly, by eps tau (grad p - rho b) . grad q with tau the shorter of
/// viscous time over density, h^2/mu, and step over density, dt/rho. Where the fluid is at rest, so that grad p = rho
/// b, it takes nothing.
class ImmersedPressure {
 public:
  /// Flow and solids must outlive it. `gravity` acts along y [length/time2].
  ImmersedPressure(const Flow& flow, const Solids& solids, double gravity);

  /// Bodies whose nodes stand at x.
  void place(std::span<const double> x, const PressureStep& step);
  /// Asks for fluxes, until they are placed anew, that give the bodies together their volume of the reference shape
  /// again over a time: where no side is open it is what the pressure's level holds, and steps leave it only nearly.
  void restore_volume(double time);
  /// F += int p div W, the forces on the fluid's momentum equations that undo the pressure inside, of solid nodes.
  void add_forces(std::span<const double> p, std::span<double> F) const;
  /// g += -int q div V + int eps tau (grad p - rho b) . grad q, 1 number a node of the fluid; the size of the fluxes
  /// before they balance each other [volume/time].
  double add_fluxes(std::span<const double> V, std::span<const double> p, std::span<double> g) const;

  /// The fluid's elements that bodies lie over, ascending; each has four pressures.
  const std::vector<int>& elements() const { return elements_; }
  /// Rows for the four pressures of each, columns for two numbers of each solid node: int q div W.
  EigenSparse divergence() const;
  /// Returns for element k the sums of eps tau grad q . grad s, 4 x 4.
  std::span<const double, 16> extension(std::size_t k) const {
    return std::span<const double, 16>(extension_.data() + 16 * k, 16);
  }

 private:
  /// A point of quadrature of a body's element, as it lies over one of the fluid's.
  struct Point {
    std::size_t element = 0, of_fluid = 0;      // the second in elements()
    double volume = 0, reference = 0, tau = 0;  // volume now and in the reference shape; tau with eps
    std::array<double, 4> q{};                  // the pressure's functions
    std::array<double, 8> slope{};              // and their gradients
    Vec<2> source{};                            // rho b
  };
  void add_point(std::span<const double> x, std::size_t e, std::size_t k);
  void set_pressure(Point& point, const PointFinder::Found& found, double& area) const;
  void number_elements();
  void sum_extension();
  int pressure_node(std::size_t of_fluid, std::size_t corner) const;
  std::size_t nodes() const { return static_cast<std::size_t>(node_count_of(solids_.mesh.kind)); }
  const double* slopes_at(std::size_t point) const { return &slopes_[2 * nodes() * point]; }

  const Flow& flow_;
  const Solids& solids_;
  double gravity_;
  PointFinder finder_;
  std::size_t points_ = 0;         // of quadrature in an element
  std::vector<double> values_;     // of the body's functions at each of them
  std::vector<double> gradients_;  // of the same in the reference shape, two numbers a node, point and element
  std::vector<double> weights_;    // volume in the reference shape of each point and element
  std::vector<int> below_;         // the fluid's element below each, when last looked for
  std::vector<double> slopes_;     // gradients of the body's functions in the present shape
  std::vector<Point> at_;
  PressureStep step_;
  double growth_ = 0;  // of the volume, over it [1/time]
  std::vector<int> elements_;
  std::vector<double> extension_;
};

}  // namespace tether::fem
