// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/errors.hpp"
#include "solvers/coupled/closed_regions.hpp"
#include "solvers/coupled/coupled_step.hpp"
#include "solvers/coupled/leaving_bodies.hpp"
#include "solvers/coupled/thin_bodies.hpp"

// What a step finds wrong or doubtful.

namespace tether::coupled {
namespace {

constexpr int farthest = 1000;  // sizes of the box that a node may be away from it

}  // namespace

/// A solid that ran away, or is turned inside out, leaves nothing to go on with.
void CoupledStep::check(const CoupledState& state) const {
  if (state.q.empty()) return;
  constexpr const char* too_much_added_mass =
      "added mass above what splitting bears, which shorter steps do not cure: mode='cut-cell' of $coupled holds";
  const bool splitting = coupled_.mode == CouplingMode::splitting;
  const auto d = static_cast<std::size_t>(surface_.dim);
  const StaggeredGrid& grid = coupled_.grid;
  for (std::size_t k = 0; k < state.q.size(); ++k) {
    const std::size_t axis = k % d;
    const double most = farthest * grid.n[axis] * grid.d[axis];  // beyond, cells cannot be counted
    if (std::abs(state.q[k] - grid.low[axis]) <= most && std::isfinite(state.u[k])) continue;
    throw RunError(fmt::format("t = {:.9g}, step {}: node {} is {} box sizes away: likely cause, {}", state.time,
                               state.steps + 1, k / d + 1, farthest,
                               splitting
                                   ? too_much_added_mass
                                   : "an open side that a body leaves through, or values of the deck that run away"));
  }
  const fem::ShapeVolumes shape = solids_.system.elements->shape(state.q);
  if (shape.least > 0) return;
  const int node = solids_.system.solids.mesh.element(shape.worst)[0];
  const Vector x = place_of(state.q, node, surface_.dim);
  throw RunError(fmt::format(
      "t = {:.9g}, step {}: element {} at ({:.6g}, {:.6g}{}) is turned inside out: likely cause, {}", state.time,
      state.steps + 1, shape.worst + 1, x[0], x[1], surface_.dim == 3 ? fmt::format(", {:.6g}", x[2]) : "",
      splitting ? too_much_added_mass : "a solid too soft for what acts on it, or steps too long for its motion"));
}

/// A warning once. What the last solution holds is then not what its forces ask for.
void CoupledStep::tell_of_unsettled_contact(CoupledState& state) {
  if (state.contact_unsettled++ > 0) return;
  messages_.push_back(fmt::format(
      "t = {:.6g}, step {}: which nodes touch walls and slide there was not settled in {} solutions: such a "
      "step may give a body energy, or put nodes that went through a wall back onto it; contact_unsettled of "
      "summary.txt counts these steps, shorter ones help",
      state.time, state.steps + 1, most_contact_solutions));
}

/// Once: the volume term has nothing to act on there.
void CoupledStep::tell_of_unmeasured_volume(const Regions& regions, CoupledState& state) {
  if (!coupled_.volume_term || coupled_.mode == CouplingMode::splitting || state.unmeasured != 0) return;
  const int region = unmeasured_region(at_.domain, at_.map, regions, surface_.cavity, state.v);
  if (region < 0) return;
  state.unmeasured = 1;
  std::size_t cell = 0;
  while (at_.domain.region[cell] != region) ++cell;
  const Vector x = coupled_.grid.middle(coupled_.grid.place_of_cell(cell));
  messages_.push_back(
      fmt::format("t = {:.6g}: the fluid about ({:.6g}, {:.6g}{}) is closed in by a body and sides of the box, and "
                  "jets fill or empty "
                  "it: volume_term does not hold its volume, which may drift from what the jets bring",
                  state.time, x[0], x[1], coupled_.grid.dim == 3 ? fmt::format(", {:.6g}", x[2]) : ""));
}

/// A warning once, where the cells are first too wide for the bodies.
void CoupledStep::note_thin_bodies(double time, CoupledState& state) {
  if (coupled_.mode != CouplingMode::cut_cell) return;
  const ThinBodies thin = thin_bodies(at_, surface_);
  if (thin.cells > 0 && state.thin_cells == 0)
    messages_.push_back(fmt::format("t = {:.6g}: {}", time, thin_text(thin, surface_.dim)));
  state.thin_cells = std::max(state.thin_cells, static_cast<long long>(thin.cells));
}

/// A warning once for each body.
void CoupledStep::note_bodies_that_left(double time, CoupledState& state) {
  const std::vector<int> sides = sides_left_by(surface_, state.q, coupled_.grid);
  for (std::size_t b = 0; b < sides.size(); ++b) {
    if (sides[b] < 0 || state.left[b] != 0) continue;
    state.left[b] = 1;
    messages_.push_back(
        fmt::format("t = {:.6g}: {}", time, leaving_text(coupled_, surface_, state.q, static_cast<int>(b), sides[b])));
  }
}

std::vector<std::string> CoupledStep::take_messages() {
  std::vector<std::string> messages = std::exchange(messages_, {});
  for (std::string& message : system_.take_messages()) messages.push_back(std::move(message));
  return messages;
}

}  // namespace tether::coupled
