// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "physics/box/flow.hpp"
#include "physics/box/matrix.hpp"
#include "physics/box/schur_complement.hpp"
#include "physics/box/solid_equations.hpp"
#include "physics/box/system.hpp"
#include "physics/solids/surroundings.hpp"

namespace tether::coupled {

/// What a step of the fluid is for the solids in it. All that is referred to must stay as long as the step takes.
struct FluidOfStep {
  const CouplingMatrix& B;  ///< of the flow's map, which may be turned
  const SparseMatrix& L;
  std::vector<double> r;     ///< flux of v* with the sources of regions [volume/time]
  std::vector<double> drag;  ///< of friction on the nodes [force]
  std::span<const std::size_t> cell;
  std::size_t cells = 0;
  std::vector<int> region;
  std::vector<std::uint8_t> closed, loose;
  double time = 0, h = 0;
  const CoarseUnknowns* coarse = nullptr;  ///< of the pressures, where the flow knows them

  /// The equations of it and solids of A and b, whose velocities cause a flux by `caused`; its own r is that of u = 0.
  CoupledEquations equations(const CouplingMatrix& caused, const SparseMatrix& A, std::span<const double> b,
                             std::span<const double> flux_left, std::span<const std::uint8_t> held) const;
};

/// The fluid about solids in a step that keeps their energy. With w = (q1 - q0)/h, the velocity that takes the solids
/// to q1, the pressures p of the step, and B by the surface's normals and areas in the middle of the way, (q0 + q1)/2,
///     B w + L p = -r:
/// the fluid gives way to what the solids sweep, and B^T p does the work on them that it takes of the fluid. (With the
/// solids' velocity at the step's end in place of w, as a linear step has it, the energy of both may grow.)
///
/// By the middle's normals a surface sweeps what its volume changes by, in the plane exactly, in space to the third
/// order and exactly where it turns. By those of the start it sweeps its way to the first order only: what is lacking,
/// of one sign where bodies turn or ripple, would come in through the box's openings and be gone with the next cells,
/// and where the box has none, bodies that are stiff could not turn at all. By any normals that q1 does not change,
/// those of an angle m, a body that turns by a has the flux 2 (cos(a - m) - cos m) V/h: a closed box lets it turn by 2
/// m or not at all.
class FluidAround final : public fem::Surroundings {
 public:
  /// All must outlive it. Springs of the solids act here, too.
  FluidAround(const SolidEquations& solids, CoupledSystem& system, const SolidSurface& surface, Flow& flow, Team& team)
      : solids_(solids), system_(system), surface_(surface), flow_(flow), team_(team) {}

  /// Begins a step from places q0 with the first guess p of its pressures. Throws RunError where more flows into a part
  /// of the fluid that nothing can widen than out of it.
  void begin(FluidOfStep step, std::span<const double> q0, std::span<const double> p);
  /// The pressures that were found [stress].
  std::vector<double> pressures() const;

  void add_forces(std::span<const double> q1, std::span<double> f) override;
  bool correct(const SparseMatrix& K, std::span<const double> right, std::span<const double> q1,
               std::span<double> change) override;
  void go(double part) override;
  double left_over(std::span<const double> q1) override;
  bool settled(std::span<const double> q1) override;
  void keep() override { kept_ = now_; }
  void go_back() override { now_ = kept_; }

 private:
  /// Pressures: in closed regions whose constant the solids feel the mean apart, whose size would drown the others.
  struct Pressures {
    std::vector<double> varying, constant;
  };
  void turn_to(std::span<const double> q1);
  CouplingMatrix flux_by_change(std::span<const double> w) const;
  void add_load_stiffness(SparseMatrix& A) const;
  std::vector<double> flux_left_over(std::span<const double> w) const;
  void find_force_of_flux(std::span<const double> flux);
  std::vector<double> velocity(std::span<const double> q1) const;
  double rounding(std::span<const double> q1, std::span<const double> w) const;

  const SolidEquations& solids_;
  CoupledSystem& system_;
  const SolidSurface& surface_;
  Flow& flow_;
  Team& team_;
  std::optional<FluidOfStep> step_;
  std::vector<double> q0_, middle_;  // the step's start, and the middle that the map is turned to [length]
  double force_of_flux_ = -1;  // what answers a flux that is left over; below 0: not known yet [force time/volume]
  ConstantPressures constants_;
  Pressures now_, kept_, before_, way_;  // way_: the last correction, from before_
};

}  // namespace tether::coupled
