// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/liquid/liquid.hpp"

#include <algorithm>
#include <cmath>

#include "physics/box/cut_faces.hpp"
#include "physics/box/liquid/extend.hpp"
#include "physics/box/liquid/move.hpp"
#include "physics/box/liquid/sums.hpp"
#include "physics/box/liquid/transfer.hpp"

namespace tether::liquid {

void LiquidOfStep::look(const LiquidFlow& flow, Particles& particles) {
  cells_ = sort_by_cells(team_, scene_.grid, particles);
  filled_ = filling(team_, scene_.grid, particles, cells_);
  Particles more = inflow_.not_yet_in(flow.owed);
  if (more.size() == 0) return;
  const CellParticles cells = sort_by_cells(team_, scene_.grid, more);
  const std::vector<double> filled = filling(team_, scene_.grid, more, cells);
  for (std::size_t c = 0; c < filled.size(); ++c) filled_[c] += filled[c];
}

/// Faces that no particle reaches take the mean of those next to them: the liquid's cells may have such.
void LiquidOfStep::give_to_faces(const coupled::FlowDomain& room, const Particles& particles, coupled::FaceValues& v) {
  constexpr int layers = 2;
  reached_ = to_faces(team_, room.grid, particles, cells_, v);
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(room.grid.dim); ++axis) {
    std::vector<std::uint8_t> known;
    for (const double volume : reached_[axis]) known.push_back(volume > 0 ? 1 : 0);
    coupled::extend_known(room.grid.dim, room.grid.faces(static_cast<int>(axis)), std::move(known), layers, v[axis]);
  }
}

void LiquidOfStep::extend(const coupled::Placement& at, double cells_crossed, coupled::FaceValues& v) const {
  const int layers = 2 + static_cast<int>(std::ceil(cells_crossed));
  extend_about_liquid(at.room(), at.domain, at.surface->distance, reached_, layers, v);
}

double LiquidOfStep::energy(const Particles& particles) const {
  const LiquidSums sums = sums_of(particles, scene_.grid.dim, scene_.density, gravity_);
  return sums.kinetic + sums.gravity;
}

CarriedEnergy LiquidOfStep::carry(const coupled::Placement& at, const coupled::FaceValues& v, double more,
                                  std::span<const double> jet_speeds, double h, Particles& particles,
                                  LiquidFlow& flow) const {
  from_faces(team_, scene_.grid, v, held_, particles);
  limit_thin_pieces(team_, scene_.grid, at.surface->distance, fastest_, more, particles);
  const std::vector<std::uint8_t> left = carry_particles(team_, at.room(), v, held_, Exits(at.room(), v), h, particles);
  if (inflow_.jets() == 0 && std::ranges::find(left, 1) == left.end()) return {};
  const double whole = energy(particles);
  flow.out += remove_marked(left, particles);
  const double kept = energy(particles);
  flow.in += inflow_.blow_in(jet_speeds, h, flow.owed, particles);
  return {energy(particles) - kept, whole - kept};
}

}  // namespace tether::liquid
