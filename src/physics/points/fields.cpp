// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/points/fields.hpp"

#include <memory>

#include "physics/points/body_motion.hpp"
#include "physics/points/derived.hpp"
#include "physics/points/steps.hpp"
#include "physics/points/strip_forces.hpp"
#include "physics/points/tracked.hpp"

namespace tether::mpm {
namespace {

using Row = Column<PointSetting, PointSums>;
using Group = ColumnGroup<PointSetting, PointSums>;
using D = Dimension;

/// Returns whether impulses of contact may act: a solid is there, and another body.
bool by_gap(const Scene& scene) { return scene.method.contact == ContactRule::gap && may_touch(scene); }

Group outside_columns() {
  return {{Row("energy_ambient", D::energy, "work done against the pressure outside membranes, part of the total",
               [](const PointSums& s) { return s.energies.ambient; })
               .when("where `pambient` acts", [](const PointSetting& s) { return s.scene.ambient != 0; }),
           Row("energy_ledger", D::energy, "heat that the ledger has given to the gas, part of its internal energy",
               [](const PointSums& s) { return s.state.heat_given; })
               .when("by a ledger", [](const PointSetting& s) { return keeps_ledger(s.scene); })}};
}

Group loss_columns() {
  const auto integration = [](const PointSums& s) {
    // Without what came in by the edges.
    return s.state.balance.integration(s.energies.sum() - s.state.strips.passed().stored);
  };
  return {{Row("energy_transfer", D::energy, "energy that went lost between points and nodes, to them and back",
               [](const PointSums& s) { return s.state.balance.transfer + (s.state.carried_at_start - s.carried); })
               .booked(Book::lost),
           Row("energy_walls", D::energy, "energy of what points gave to nodes that walls hold, which is lost by APIC",
               [](const PointSums& s) { return s.state.balance.walls; })
               .booked(Book::lost),
           Row("energy_integration", D::energy,
               "work of the nodes' forces that nothing stored, which is the steps' own error; less what the ledger has "
               "given back",
               integration)
               .booked(Book::lost),
           Row("energy_contact", D::energy, "energy that impulses of contact have taken, no longer in the total",
               [](const PointSums& s) { return s.state.contact.lost(); })
               .booked(Book::lost)
               .when("with a solid and another body", [](const PointSetting& s) { return by_gap(s.scene); })}};
}

/// Makes a row of what passed.
Row passed(const char* name, Dimension dimension, const char* meaning, double Passed::*amount) {
  return {name, dimension, meaning, [amount](const PointSums& s) { return s.state.strips.passed().*amount; }};
}

Group edge_columns() {
  return {{"with open edges", [](const PointSetting& s) { return s.scene.edges.any(); }},
          {passed("edge_mass_in", D::mass, "mass that came in through open edges", &Passed::mass_in),
           passed("edge_mass_out", D::mass, "mass that went out through open edges", &Passed::mass_out),
           passed("edge_mass_back", D::mass,
                  "mass of both that came in through an outflow or went out through an inflow", &Passed::back),
           passed("edge_momentum_x", D::momentum, "momentum in x that came in through open edges, less what went out",
                  &Passed::momentum_x),
           passed("edge_momentum_y", D::momentum, "momentum in y that came in through open edges, less what went out",
                  &Passed::momentum_y),
           passed("edge_energy_in", D::energy, "energy that came in through open edges", &Passed::energy_in)
               .booked(Book::gained),
           passed("edge_energy_out", D::energy, "energy that went out through open edges", &Passed::energy_out)
               .booked(Book::given)}};
}

/// Bodies whose volume shows whether a run goes wrong.
Group volume_column() {
  const auto has_volumes = [](const PointSetting& s) { return has_solid(s.scene) || find_body<LinearFluid>(s.scene); };
  const auto volume = [](const PointSums& s, std::size_t b) { return volume_of(s.scene, b, s.state.points, s.order); };
  return {{"with solids or linear fluids", has_volumes},
          {Row("body_volume", D::volume,
               "volume: of solids and linear fluids by the strain of their stress, of gas by its density, of membranes "
               "that at the start",
               volume)
               .each(Per::body)}};
}

}  // namespace

const ColumnTable<PointSetting, PointSums>& history_table() {
  static const ColumnTable<PointSetting, PointSums> table(
      {energy_columns(), momentum_columns(), plane_spin_column(), outside_columns(), loss_columns(), edge_columns(),
       angle_column<PointSetting, PointSums>([](const PointSetting& s) { return s.scene.outputs.tracked_angle; }),
       body_columns(), volume_column(), tracked_columns()});
  return table;
}

Columns<PointSums> history_columns(const Scene& scene) {
  PointSetting setting{{}, scene};
  for (const Body& body : scene.bodies) setting.body_names.push_back(body.name);
  for (std::size_t k = 0; k < scene.tracked.size(); ++k) setting.point_names.push_back(tracked_name(scene, k));
  return {history_table(), setting};
}

PointSums sums_of(const State& state, const Scene& scene) {
  const Points& P = state.points;
  PointSums s{{}, state, scene, order_within(state), {}};
  const Order& order = s.order;
  s.energies = stored_energy(scene, state, order);
  const double quarter = scene.method.kernel == Kernel::bspline ? 0.25 : 0;  // bilinear fields are not orthogonal
  const Pair D = quarter * pair(scene.grid.dx * scene.grid.dx, scene.grid.dy * scene.grid.dy);
  BodyMotion all;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const BodyMotion body = motion_of(order.of(b), P, D);
    s.bodies.push_back(body.sums());
    if (state.blocks[b] && scene.method.transfer == Transfer::apic) s.carried += body.kinetic;
    all.add(body);
  }
  s.time = state.time, s.dt = state.dt_last;
  s.kinetic = all.kinetic, s.strain = s.energies.strain, s.internal = s.energies.internal;
  s.potential = -scene.gravity * all.my;
  s.total = s.kinetic + s.strain + s.internal + s.potential + s.energies.ambient;
  s.mass = all.mass, s.momentum = {all.px, all.py}, s.angular[2] = all.angular;
  s.tracked = tracked_sums(state, scene, order);
  return s;
}

namespace {

/// What fields of points are made from: point k of the scene stands in slot order.slots[k], or the point that runs for
/// it does.
struct PointSource {
  const Scene& scene;
  const Points& P;
  Order order;
  std::vector<double> pressures;  // as StepSet::gas_pressures
  Unfolding unfolding;

  std::size_t number(std::size_t k) const {
    return unfolding.on() ? k : static_cast<std::size_t>(P.id[order.slots[k]]);
  }
  Vec<2> place(std::size_t k) const { return unfolding.place(k, {P.x[order.slots[k]], P.y[order.slots[k]]}); }
  double mass(std::size_t k) const { return P.mass[order.slots[k]] * unfolding.share(k); }
  Extent extent(std::size_t k) const {
    Extent extent = extent_of(scene, order.body_of(k), P, order.slots[k], pressures);
    extent.volume *= unfolding.share(k);
    return extent;
  }
  Strain strain(std::size_t k) const { return strain_of(scene, order.body_of(k), P, order.slots[k]); }
};

/// What fields of nodes are made from: node k of the deck's grid is node `nodes[k]` of the frame.
struct NodeSource {
  std::vector<std::size_t> nodes = {};
  NodeSumsRow sums = NodeSumsRow(0);
  double gravity = 0;
  std::vector<double> density = {}, pressure = {}, energy = {};  ///< sum m_p q_p N_i of each quantity q

  NodeSums at(std::size_t k) const { return sums[nodes[k]]; }
};

/// An array of the points.
Value<PointSource> of(LineArray<double> Points::*array) {
  return [array](const PointSource& s, std::size_t k) { return s.P.at(array, s.order.slots[k]); };
}
/// Returns what follows from the points' laws.
Value<PointSource> of(double Extent::*number) {
  return [number](const PointSource& s, std::size_t k) { return s.extent(k).*number; };
}
Value<PointSource> of(double Strain::*number) {
  return [number](const PointSource& s, std::size_t k) { return s.strain(k).*number; };
}

const ColumnTable<ColumnSetting, PointSource>& point_table() {
  static const ColumnTable<ColumnSetting, PointSource> table({{{
      {"x", D::length, "place, x", [](const PointSource& s, std::size_t k) { return s.place(k)[0]; }},
      {"y", D::length, "place, y", [](const PointSource& s, std::size_t k) { return s.place(k)[1]; }},
      {"id", D::whole, "number of the point, from 1",
       [](const PointSource& s, std::size_t k) { return static_cast<double>(s.number(k) + 1); }},
      {"body", D::whole, "number of its body, from 1",
       [](const PointSource& s, std::size_t k) { return static_cast<double>(s.order.body_of(k) + 1); }},
      {"vx", D::velocity, "velocity, x", of(&Points::vx)},
      {"vy", D::velocity, "velocity, y", of(&Points::vy)},
      {"mass", D::mass, "mass", [](const PointSource& s, std::size_t k) { return s.mass(k); }},
      {"volume", D::volume, "volume", of(&Extent::volume)},
      {"sxx", D::stress, "stress, xx", of(&Points::sxx)},
      {"syy", D::stress, "stress, yy", of(&Points::syy)},
      {"sxy", D::stress, "stress, xy", of(&Points::sxy)},
      {"szz", D::stress,
       "stress across the plane, about an axis and of membranes the hoop's; of gas in the plane minus its pressure",
       of(&Extent::across)},
      {"density", D::density, "density",
       [](const PointSource& s, std::size_t k) { return s.mass(k) / s.extent(k).volume; }},
      {"pressure", D::stress, "gas: pressure without its viscous parts; else minus the mean stress",
       of(&Extent::pressure)},
      {"specific_energy", D::specific_energy, "gas: internal energy per mass", of(&Points::energy)},
      {"strain", D::number, "membrane: strain along its tangent", of(&Points::strain)},
      {"strain_hoop", D::number, "membrane: strain across the plane", of(&Points::hoop)},
      {"strain_xx", D::number, "elastic strain, xx", of(&Strain::xx)},
      {"strain_yy", D::number, "elastic strain, yy", of(&Strain::yy)},
      {"strain_xy", D::number, "elastic strain, xy (tensor)", of(&Strain::xy)},
      {"normal_x", D::number, "membrane: unit normal, x",
       [](const PointSource& s, std::size_t k) { return -s.P.at(&Points::ty, s.order.slots[k]); }},
      {"normal_y", D::number, "membrane: unit normal, y", of(&Points::tx)},
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

/// sum m_p q_p N_i at each node of the frame, of a quantity q(k) of all points in their order.
template <class Quantity>
std::vector<double> sum_at_nodes(const State& state, const StepSet& set, const Order& order, const Quantity& q) {
  std::vector<double> of_slots(state.points.size()), sums(state.grid.frame.shape.nodes(), 0.0);
  for (std::size_t k = 0; k < order.slots.size(); ++k) of_slots[order.slots[k]] = q(k);
  set.map_quantity(state, of_slots, sums, Parity::even);
  return sums;
}

}  // namespace

FieldsInTurn point_fields(const State& state, const Scene& scene) {
  const Unfolding unfolding(scene.strip.get());
  const auto source =
      std::make_shared<const PointSource>(PointSource{scene, state.points, unfolded(order_within(state), unfolding),
                                                      step_set(scene).gas_pressures(state, scene), unfolding});
  return Columns<PointSource>(point_table(), ColumnSetting{})
      .in_turn(state.time, source->order.slots.size(), [source]() -> const PointSource& { return *source; });
}

Snapshot grid_fields(const State& state, const Scene& scene, const StepSet& set) {
  const Frame& frame = state.grid.frame;
  const PointSource points{scene, state.points, order_of_all(state), set.gas_pressures(state, scene), Unfolding()};
  NodeSource source{.gravity = scene.gravity};
  for (std::size_t k = 0; k < frame.deck.nodes(); ++k) source.nodes.push_back(frame.of_deck(k));
  source.sums = NodeSumsRow(frame.shape.nodes());
  set.map_all(state, scene, source.sums);
  if (scene.strip) put_forces_across(state, scene, set, points.order, source.sums);
  const auto sum = [&](const auto& quantity) { return sum_at_nodes(state, set, points.order, quantity); };
  source.density = sum([&](std::size_t k) { return points.mass(k) / points.extent(k).volume; });
  source.pressure = sum([&](std::size_t k) { return points.extent(k).pressure; });
  source.energy = sum([&](std::size_t k) { return state.points.at(&Points::energy, points.order.slots[k]); });
  return Columns<NodeSource>(node_table(), ColumnSetting{}).snapshot(state.time, source.nodes.size(), source);
}

}  // namespace tether::mpm
