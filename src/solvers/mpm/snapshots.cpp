// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "solvers/mpm/derived.hpp"
#include "solvers/mpm/fields.hpp"
#include "solvers/mpm/steps.hpp"

namespace tether::mpm {
namespace {

Field field(const char* name, Dimension dimension, const char* meaning, std::vector<double> values) {
  return {{name, dimension, meaning, Per::scene}, std::move(values)};
}

/// An array of the points in an order.
std::vector<double> in_order(const std::vector<double>& array, const Order& order) {
  std::vector<double> values;
  values.reserve(order.slots.size());
  for (const std::size_t slot : order.slots) values.push_back(array[slot]);
  return values;
}

std::vector<double> numbers(const Points& points, const Order& order) {
  std::vector<double> values;
  values.reserve(order.slots.size());
  for (const std::size_t slot : order.slots) values.push_back(points.id[slot] + 1.0);
  return values;
}

/// Over the nodes of the deck's grid.
template <class Get>
std::vector<double> over_nodes(const Frame& frame, const Get& get) {
  std::vector<double> values;
  values.reserve(frame.deck.nodes());
  for (std::size_t n = 0; n < frame.deck.nodes(); ++n) values.push_back(get(frame.of_deck(n)));
  return values;
}

double quotient(double a, double m) { return m > 0 ? a / m : 0; }

/// sum m_p q_p N_i / m_i of a quantity q of all points in their order.
std::vector<double> mean_at_nodes(const State& state, const StepSet& set, const std::vector<NodeSums>& sums,
                                  const Order& order, const std::vector<double>& q) {
  std::vector<double> of_slots(q.size()), values(sums.size(), 0.0);
  for (std::size_t k = 0; k < q.size(); ++k) of_slots[order.slots[k]] = q[k];
  set.map_quantity(state, of_slots, values);
  return over_nodes(state.grid.frame, [&](std::size_t n) { return quotient(values[n], sums[n].m); });
}

}  // namespace

Snapshot point_fields(const State& state, const Scene& scene) {
  const Points& P = state.points;
  const Order order = order_within(state);
  const auto of = [&](const std::vector<double>& array) { return in_order(array, order); };
  DerivedFields derived = derived_fields(scene, P, order, step_set(scene).gas_pressures(state, scene));
  using D = Dimension;
  return {state.time,
          {field("x", D::length, "place, x", of(P.x)),
           field("y", D::length, "place, y", of(P.y)),
           field("id", D::number, "number of the point, from 1", numbers(P, order)),
           field("body", D::number, "number of its body, from 1", std::move(derived.body)),
           field("vx", D::velocity, "velocity, x", of(P.vx)),
           field("vy", D::velocity, "velocity, y", of(P.vy)),
           field("mass", D::mass, "mass", of(P.mass)),
           field("volume", D::volume, "volume", std::move(derived.volume)),
           field("sxx", D::stress, "stress, xx", of(P.sxx)),
           field("syy", D::stress, "stress, yy", of(P.syy)),
           field("sxy", D::stress, "stress, xy", of(P.sxy)),
           field("szz", D::stress, "stress across the plane, about an axis and of membranes: the hoop's", of(P.szz)),
           field("density", D::density, "density", std::move(derived.density)),
           field("pressure", D::stress, "gas: pressure without its viscous parts; else minus the mean stress",
                 std::move(derived.pressure)),
           field("specific_energy", D::specific_energy, "gas: internal energy per mass", of(P.energy)),
           field("strain", D::number, "membrane: strain along its tangent", of(P.strain)),
           field("strain_hoop", D::number, "membrane: strain across the plane", of(P.hoop)),
           field("strain_xx", D::number, "elastic strain, xx", std::move(derived.strain_xx)),
           field("strain_yy", D::number, "elastic strain, yy", std::move(derived.strain_yy)),
           field("strain_xy", D::number, "elastic strain, xy (tensor)", std::move(derived.strain_xy)),
           field("normal_x", D::number, "membrane: unit normal, x", std::move(derived.normal_x)),
           field("normal_y", D::number, "membrane: unit normal, y", std::move(derived.normal_y))}};
}

Snapshot grid_fields(const State& state, const Scene& scene, const StepSet& set) {
  std::vector<NodeSums> sums(state.grid.frame.shape.nodes());
  set.map_all(state, scene, sums);
  const Order order = order_of_all(state);
  const DerivedFields derived = derived_fields(scene, state.points, order, set.gas_pressures(state, scene));
  const auto nodes = [&](const auto& get) {
    return over_nodes(state.grid.frame, [&](std::size_t n) { return get(sums[n]); });
  };
  const auto mean = [&](const std::vector<double>& q) { return mean_at_nodes(state, set, sums, order, q); };
  using D = Dimension;
  return {state.time,
          {field("mass", D::mass, "mass mapped to the node", nodes([](const NodeSums& n) { return n.m; })),
           field("vx", D::velocity, "mapped velocity, x",
                 nodes([](const NodeSums& n) { return quotient(n.momentum[0], n.m); })),
           field("vy", D::velocity, "mapped velocity, y",
                 nodes([](const NodeSums& n) { return quotient(n.momentum[1], n.m); })),
           field("force_x", D::force, "internal and body force before walls, x",
                 nodes([](const NodeSums& n) { return n.force[0]; })),
           field("force_y", D::force, "internal and body force before walls, y",
                 nodes([&](const NodeSums& n) { return n.force[1] + n.m * scene.gravity; })),
           field("density", D::density, "mean of the points by mass", mean(derived.density)),
           field("pressure", D::stress, "mean of the points by mass", mean(derived.pressure)),
           field("specific_energy", D::specific_energy, "mean of the points by mass",
                 mean(in_order(state.points.energy, order)))}};
}

}  // namespace tether::mpm
