// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/mpm/derived.hpp"
#include "solvers/mpm/fields.hpp"
#include "solvers/mpm/steps.hpp"

namespace tether::mpm {
namespace {

using D = Dimension;

/// What fields of points are made from: point k of the scene stands in slot order.slots[k].
struct PointSource {
  const Points& P;
  Order order;
  DerivedFields derived;
};

/// What fields of nodes are made from: node k of the deck's grid is node `nodes[k]` of the frame.
struct NodeSource {
  std::vector<std::size_t> nodes = {};
  std::vector<NodeSums> sums = {};
  double gravity = 0;
  std::vector<double> density = {}, pressure = {}, energy = {};  ///< sum m_p q_p N_i of each quantity q

  const NodeSums& at(std::size_t k) const { return sums[nodes[k]]; }
};

/// An array of the points.
Value<PointSource> of(std::vector<double> Points::*array) {
  return [array](const PointSource& s, std::size_t k) { return (s.P.*array)[s.order.slots[k]]; };
}
/// One that follows from the points' laws.
Value<PointSource> of(std::vector<double> DerivedFields::*array) {
  return [array](const PointSource& s, std::size_t k) { return (s.derived.*array)[k]; };
}

const ColumnTable<ColumnSetting, PointSource>& point_table() {
  using F = DerivedFields;
  static const ColumnTable<ColumnSetting, PointSource> table({{{
      {"x", D::length, "place, x", of(&Points::x)},
      {"y", D::length, "place, y", of(&Points::y)},
      {"id", D::number, "number of the point, from 1",
       [](const PointSource& s, std::size_t k) { return s.P.id[s.order.slots[k]] + 1.0; }},
      {"body", D::number, "number of its body, from 1", of(&F::body)},
      {"vx", D::velocity, "velocity, x", of(&Points::vx)},
      {"vy", D::velocity, "velocity, y", of(&Points::vy)},
      {"mass", D::mass, "mass", of(&Points::mass)},
      {"volume", D::volume, "volume", of(&F::volume)},
      {"sxx", D::stress, "stress, xx", of(&Points::sxx)},
      {"syy", D::stress, "stress, yy", of(&Points::syy)},
      {"sxy", D::stress, "stress, xy", of(&Points::sxy)},
      {"szz", D::stress,
       "stress across the plane, about an axis and of membranes the hoop's; of gas in the plane minus its pressure",
       of(&F::across)},
      {"density", D::density, "density", of(&F::density)},
      {"pressure", D::stress, "gas: pressure without its viscous parts; else minus the mean stress", of(&F::pressure)},
      {"specific_energy", D::specific_energy, "gas: internal energy per mass", of(&Points::energy)},
      {"strain", D::number, "membrane: strain along its tangent", of(&Points::strain)},
      {"strain_hoop", D::number, "membrane: strain across the plane", of(&Points::hoop)},
      {"strain_xx", D::number, "elastic strain, xx", of(&F::strain_xx)},
      {"strain_yy", D::number, "elastic strain, yy", of(&F::strain_yy)},
      {"strain_xy", D::number, "elastic strain, xy (tensor)", of(&F::strain_xy)},
      {"normal_x", D::number, "membrane: unit normal, x", of(&F::normal_x)},
      {"normal_y", D::number, "membrane: unit normal, y", of(&F::normal_y)},
  }}});
  return table;
}

double quotient(double a, double m) { return m > 0 ? a / m : 0; }

/// The mean of the points by mass, sum m_p q_p N_i / m_i.
Value<NodeSource> mean(std::vector<double> NodeSource::*array) {
  return [array](const NodeSource& s, std::size_t k) { return quotient((s.*array)[s.nodes[k]], s.at(k).m); };
}

const ColumnTable<ColumnSetting, NodeSource>& node_table() {
  using S = NodeSource;
  static const ColumnTable<ColumnSetting, NodeSource> table({{{
      {"mass", D::mass, "mass mapped to the node", [](const S& s, std::size_t k) { return s.at(k).m; }},
      {"vx", D::velocity, "mapped velocity, x",
       [](const S& s, std::size_t k) { return quotient(s.at(k).momentum[0], s.at(k).m); }},
      {"vy", D::velocity, "mapped velocity, y",
       [](const S& s, std::size_t k) { return quotient(s.at(k).momentum[1], s.at(k).m); }},
      {"force_x", D::force, "internal and body force before walls, x",
       [](const S& s, std::size_t k) { return s.at(k).force[0]; }},
      {"force_y", D::force, "internal and body force before walls, y",
       [](const S& s, std::size_t k) { return s.at(k).force[1] + s.at(k).m * s.gravity; }},
      {"density", D::density, "mean of the points by mass", mean(&S::density)},
      {"pressure", D::stress, "mean of the points by mass", mean(&S::pressure)},
      {"specific_energy", D::specific_energy, "mean of the points by mass", mean(&S::energy)},
  }}});
  return table;
}

/// sum m_p q_p N_i at each node of the frame, of a quantity q of all points in their order.
std::vector<double> sum_at_nodes(const State& state, const StepSet& set, const Order& order,
                                 const std::vector<double>& q) {
  std::vector<double> of_slots(q.size()), sums(state.grid.frame.shape.nodes(), 0.0);
  for (std::size_t k = 0; k < q.size(); ++k) of_slots[order.slots[k]] = q[k];
  set.map_quantity(state, of_slots, sums);
  return sums;
}

}  // namespace

Snapshot point_fields(const State& state, const Scene& scene) {
  const Points& P = state.points;
  const Order order = order_within(state);
  const PointSource source{P, order, derived_fields(scene, P, order, step_set(scene).gas_pressures(state, scene))};
  return Columns<PointSource>(point_table(), ColumnSetting{}).snapshot(state.time, order.slots.size(), source);
}

Snapshot grid_fields(const State& state, const Scene& scene, const StepSet& set) {
  const Frame& frame = state.grid.frame;
  const Order order = order_of_all(state);
  const DerivedFields derived = derived_fields(scene, state.points, order, set.gas_pressures(state, scene));
  std::vector<double> energy;
  for (const std::size_t slot : order.slots) energy.push_back(state.points.energy[slot]);
  NodeSource source{.gravity = scene.gravity};
  for (std::size_t k = 0; k < frame.deck.nodes(); ++k) source.nodes.push_back(frame.of_deck(k));
  source.sums.resize(frame.shape.nodes());
  set.map_all(state, scene, source.sums);
  source.density = sum_at_nodes(state, set, order, derived.density);
  source.pressure = sum_at_nodes(state, set, order, derived.pressure);
  source.energy = sum_at_nodes(state, set, order, energy);
  return Columns<NodeSource>(node_table(), ColumnSetting{}).snapshot(state.time, source.nodes.size(), source);
}

}  // namespace tether::mpm
