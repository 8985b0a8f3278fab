// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/bars/bars.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tether::fem {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

void kick(BarState& state, double dt) {
  const std::size_t nodes = state.x.size();
  for (std::size_t n = 0; n < nodes; ++n) state.vx[n] += dt * state.ax[n];
  for (std::size_t n = 0; n < nodes; ++n) state.vy[n] += dt * state.ay[n];
}

void drift(const BarArrays& bars, BarState& state, double dt) {
  const std::size_t nodes = state.x.size();
  for (std::size_t n = 0; n < nodes; ++n) state.x[n] += dt * state.vx[n];
  for (std::size_t n = 0; n < nodes; ++n) state.y[n] += dt * state.vy[n];
  for (std::size_t k = 0; k < bars.sliding.size(); ++k) {
    const Anchor& anchor = bars.sliding[k];
    auto& along = anchor.slides == holds_x ? state.x : state.y;
    along[bars.sliding_node[k]] = along[anchor.point];
  }
}

/// The parts of a state, once for both ways.
template <class Exchange, class AnyState>
void exchange(Exchange& with, AnyState& state) {
  with("x", state.x), with("y", state.y), with("vx", state.vx), with("vy", state.vy);
  with("bar_ax", state.ax), with("bar_ay", state.ay);
  exchange_clock(with, state);
  with("carried_over", state.carried_over), with("behind_warned", state.behind_warned);
}

}  // namespace

BarArrays::BarArrays(const Scene& scene, const BarMesh& mesh) {
  for (const Bar& bar : mesh.bars) {
    a.push_back(static_cast<std::uint32_t>(bar.a)), b.push_back(static_cast<std::uint32_t>(bar.b));
    per_rest.push_back(1 / bar.rest), strain.push_back(bar.strain);
    section_modulus.push_back(bar.E * bar.section), least.push_back(bar.one_way ? 0 : -infinity);
  }
  for (std::size_t p = 0; p < scene.points.size(); ++p) {
    const double per_mass = 1 / scene.points.mass[p];
    per_mass_x.push_back(mesh.held[p] & holds_x ? 0 : per_mass);
    per_mass_y.push_back(mesh.held[p] & holds_y ? 0 : per_mass);
    fall.push_back(mesh.held[p] & holds_y ? 0 : scene.gravity);
  }
  for (const Anchor& anchor : mesh.anchors) {
    if (anchor.slides != holds_none) {
      sliding.push_back(anchor);
      sliding_node.push_back(static_cast<std::uint32_t>(fall.size()));
    }
    per_mass_x.push_back(0), per_mass_y.push_back(0), fall.push_back(0);
  }
}

BarState start(const Scene& scene, const BarMesh& mesh, const BarArrays& arrays) {
  const PointSet& P = scene.points;
  BarState state;
  state.x = P.x, state.y = P.y, state.vx = P.vx, state.vy = P.vy;
  for (std::size_t p = 0; p < P.size(); ++p) {
    if (mesh.held[p] & holds_x) state.vx[p] = 0;
    if (mesh.held[p] & holds_y) state.vy[p] = 0;
  }
  for (const Anchor& anchor : mesh.anchors) {
    state.x.push_back(anchor.x), state.y.push_back(anchor.y);
    state.vx.push_back(0), state.vy.push_back(0);
  }
  state.ax.resize(state.x.size()), state.ay.resize(state.x.size());
  accelerate(arrays, state);
  return state;
}

bool accelerate(const BarArrays& bars, BarState& state) {
  std::fill(state.ax.begin(), state.ax.end(), 0.0);
  std::fill(state.ay.begin(), state.ay.end(), 0.0);
  bool sound = true;
  for (std::size_t e = 0; e < bars.bars(); ++e) {
    const std::size_t a = bars.a[e], b = bars.b[e];
    const double dx = state.x[b] - state.x[a], dy = state.y[b] - state.y[a];
    const double length = std::sqrt(dx * dx + dy * dy);
    sound &= length < infinity;  // false for NaN, too
    const double tension = bars.section_modulus[e] * carried(bars, e, strain_of(bars, e, length));
    const double pull = length > 0 ? tension / length : 0;  // nodes in one place know no direction
    state.ax[a] += pull * dx, state.ay[a] += pull * dy;
    state.ax[b] -= pull * dx, state.ay[b] -= pull * dy;
  }
  const std::size_t nodes = state.x.size();
  for (std::size_t n = 0; n < nodes; ++n) state.ax[n] *= bars.per_mass_x[n];
  for (std::size_t n = 0; n < nodes; ++n) state.ay[n] = state.ay[n] * bars.per_mass_y[n] + bars.fall[n];
  return sound;
}

bool central_difference_step(const BarArrays& bars, BarState& state, double dt) {
  kick(state, 0.5 * dt);
  drift(bars, state, dt);
  const bool sound = accelerate(bars, state);
  kick(state, 0.5 * dt);
  return sound;
}

SavedState save(const BarState& state) {
  StateSaver saver;
  exchange(saver, state);
  return saver.take();
}

void restore(BarState& state, const SavedState& saved) {
  StateRestorer restorer(saved);
  exchange(restorer, state);
}

}  // namespace tether::fem
