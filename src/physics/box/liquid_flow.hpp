// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "physics/box/grid_flow.hpp"
#include "physics/box/liquid/liquid.hpp"
#include "physics/box/liquid/near_solids.hpp"
#include "physics/box/system.hpp"

namespace tether::coupled {

/// A liquid with a surface on the regular grid: particles carry it, and its velocity.
class LiquidFlow final : public GridFlow {
 public:
  /// All must outlive it.
  LiquidFlow(const Coupled& scene, const Vec<3>& gravity, const SolidSurface& surface, const SolidEquations& solids,
             CoupledSystem& system, Team& team)
      : GridFlow(scene, gravity, surface, solids, team), system_(system), liquid_(scene, gravity, team) {}

  Placement placed(std::span<const double> q) const override { return placer_.at(q, liquid_.filled()); }
  void place(CoupledState& state) override;
  void finish_start(double h, CoupledState& state) override;

  void begin(CoupledState& state, double h) override;
  /// A liquid's own energy has that of gravity, and air beyond open sides does not press.
  void book_forces(CoupledState& /*state*/, double /*h*/) const override {}
  void end(const FaceValues& change, CoupledState& state, double h) override;
  bool keeps_volume(const CoupledState& state) const override { return state.full != 0; }
  void extend_drive(CoupledState& state) const override;

  void add_sums(const CoupledState& state, CoupledSums& sums) const override;
  Snapshot surface_fields(const CoupledState& state) const override;
  Snapshot particle_fields(const CoupledState& state) const override;

 protected:
  void fill(CoupledState& state) override;
  void extend(double h, double cells_crossed, FaceValues& v) const override;
  void keep_rubbed_faces(const FaceValues& given, const FaceValues& change, double h,
                         CoupledState& state) const override;
  void place_after_step(CoupledState& state) override;
  void find_parts() override;
  Beyond beyond_open_sides() const override { return Beyond::nothing; }  // as at its surface

 private:
  /// A liquid's energy, and what of all that is booked is its own.
  struct Books {
    double energy = 0, booked = 0;  ///< [energy]
  };
  Books books_of(const CoupledState& state) const;
  void book(CoupledState& state) const;
  void note_air(CoupledState& state) const;
  void move_particles(CoupledState& state, double h);
  void settle_particles(const Room& room, CoupledState& state);
  liquid::NearSolids near_solids(const Room& room) const;

  CoupledSystem& system_;
  liquid::LiquidOfStep liquid_;
  Books before_;  // the step
};

}  // namespace tether::coupled
