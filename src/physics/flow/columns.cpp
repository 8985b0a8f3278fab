// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/flow/columns.hpp"

#include <fmt/format.h>

namespace tether::fem {
namespace {

using Row = Column<FlowSetting, FlowSums>;
using Group = ColumnGroup<FlowSetting, FlowSums>;
using Given = When<FlowSetting>;
using D = Dimension;

const Given& with_bodies() {
  static const Given when("with immersed bodies", [](const FlowSetting& s) { return s.with_bodies; });
  return when;
}

/// Returns whether drag and lift are wanted as coefficients.
const Given& with_coefficients() {
  static const Given when("with `speed` and `length`",
                          [](const FlowSetting& s) { return s.flow.speed > 0 && s.flow.length > 0; });
  return when;
}

/// Energy that was exchanged.
Row exchanged(const char* name, const char* meaning, Book book, double FlowExchange::*amount) {
  return Row(name, D::energy, meaning, [amount](const FlowSums& s) { return s.exchanged.*amount; }).booked(book);
}

/// A steady flow exchanges over no time, and nothing is booked.
Group exchange_columns() {
  using All = FlowExchange;
  using enum Book;
  const Given q1q1("of `element='q1q1'`", [](const FlowSetting& s) { return s.flow.element == FlowElement::q1q1; });
  const Given euler("of `integrator='euler'`",
                    [](const FlowSetting& s) { return s.flow.integrator == FlowIntegrator::euler; });
  return {
      {"not steady", [](const FlowSetting& s) { return s.flow.integrator != FlowIntegrator::steady; }},
      {exchanged("energy_walls", "work of moving walls on the fluid", gained, &All::walls),
       exchanged("energy_inflow", "work of inflows, and the kinetic energy that they bring", gained, &All::inflows),
       exchanged("energy_open", "work at open sides, less the kinetic energy that leaves there", gained, &All::open),
       exchanged("energy_body_forces", "work of gravity and body forces on the fluid", gained, &All::body_forces),
       exchanged("energy_loads", "work that loads have done on the bodies", gained, &All::loads).when(with_bodies()),
       exchanged("energy_supports", "work of supports and walls that move", gained, &All::supports).when(with_bodies()),
       exchanged("energy_viscous", "energy that viscosity turned into heat", given, &All::viscosity),
       exchanged("energy_stabilised", "energy lost to what stabilises equal orders of velocity and pressure", lost,
                 &All::stabilised)
           .when(q1q1),
       exchanged("energy_advected", "energy lost by advection where velocities are not quite free of divergence", lost,
                 &All::advected),
       exchanged("energy_immersed", "energy lost in bodies by their steps and as they take the fluid's velocity anew",
                 lost, &All::immersed)
           .when(with_bodies()),
       exchanged("energy_stepped", "kinetic energy of the fluid lost by steps of backward Euler", lost, &All::stepped)
           .when(euler)}};
}

Group fluid_columns() {
  const auto momentum = [](const FlowSums& s, std::size_t axis, std::size_t) { return s.momentum[axis]; };
  return {
      {{"energy_pressure", D::energy,
        "size of the pressure times volume: what rounding and settling at rest are small against",
        &FlowSums::pressure_energy},
       {"mass", D::mass, "mass of the fluid, and of as much of it as solids are in the place of", &FlowSums::mass},
       Row("momentum_", D::momentum, "momentum of fluid, and of as much of it as solids are in the place of", momentum)
           .vector(),
       {"stream_min", D::flux, "least value of the stream function at a node, 0 at the first", &FlowSums::least_stream},
       {"stream_max", D::flux, "largest value of the stream function at a node", &FlowSums::most_stream},
       Row("reynolds", D::number, "Reynolds number by speed and length of the deck", &FlowSums::reynolds)
           .when(with_coefficients())}};
}

/// "force of the fluid on the cylinder, mean of the last step".
std::string force_meaning(const FlowSetting& s, std::size_t k) {
  return fmt::format("force of the fluid{} on {}, mean of the last step", s.with_bodies ? " and of bodies' clamps" : "",
                     s.flow.forces[k].name);
}

Group force_columns() {
  const auto of = [](PlaneForce RecordedForce::*part) {
    return [part](const FlowSums& s, std::size_t axis, std::size_t k) {
      const PlaneForce& force = s.forces.at(k).*part;
      return axis == 0 ? force.x : force.y;
    };
  };
  const auto torque = [](PlaneForce RecordedForce::*part) {
    return [part](const FlowSums& s, std::size_t k) { return (s.forces.at(k).*part).torque; };
  };
  using Force = RecordedForce;
  return numbered<FlowSetting, FlowSums>(
      {{"of `force_on`", [](const FlowSetting& s) { return s.flow.forces.size(); }},
       {Row("side_force_", D::force, "force of the fluid and of bodies' clamps on what is named, mean of the last step",
            of(&Force::all))
            .vector()
            .meaning_of(force_meaning),
        Row("side_torque_z", D::torque, "torque of this force about (`force_x`, `force_y`)", torque(&Force::all)),
        Row("side_clamp_", D::force, "the clamps' part of the force", of(&Force::clamps)).vector().when(with_bodies()),
        Row("side_clamp_torque_z", D::torque, "the clamps' part of the torque", torque(&Force::clamps))
            .when(with_bodies()),
        Row("drag", D::number, "force in x over speed^2 length density/2",
            [](const FlowSums& s, std::size_t k) { return s.forces.at(k).all.x / s.unit_force; })
            .when(with_coefficients()),
        Row("lift", D::number, "force in y over speed^2 length density/2", [](const FlowSums& s, std::size_t k) {
          return s.forces.at(k).all.y / s.unit_force;
        }).when(with_coefficients())}});
}

Group probe_columns() {
  const auto pressure = [](const FlowSums& s, std::size_t k) { return s.probes.at(k).pressure; };
  const auto velocity = [](const FlowSums& s, std::size_t axis, std::size_t k) {
    return s.probes.at(k).velocity[axis];
  };
  const auto stream = [](const FlowSums& s, std::size_t k) { return s.probes.at(k).stream; };
  return numbered<FlowSetting, FlowSums>({{"of `probe`", [](const FlowSetting& s) { return s.flow.probes.size(); }},
                                          {{"probe_p", D::stress, "pressure at the probe, of the last step", pressure},
                                           Row("probe_v", D::velocity, "velocity at the probe", velocity).vector(),
                                           {"probe_stream", D::flux, "stream function at the probe", stream}}});
}

Group difference_columns() {
  const auto meaning = [](const FlowSetting& s, std::size_t k) {
    const auto& [first, second] = s.flow.differences[k];
    return fmt::format("pressure at probe {} less that at probe {}", first + 1, second + 1);
  };
  return numbered<FlowSetting, FlowSums>(
      {{"of `difference`", [](const FlowSetting& s) { return s.flow.differences.size(); }},
       {Row("pressure_difference", D::stress, "pressure at one probe less that at another",
            [](const FlowSums& s, std::size_t k) { return s.differences.at(k); })
            .meaning_of(meaning)}});
}

Group body_force_columns() {
  const auto of = [](const char* name, const char* meaning, auto&& number) {
    return Row(name, D::force, meaning,
               [number](const FlowSums& s, std::size_t axis, std::size_t b) { return number(s.on_bodies.at(b), axis); })
        .vector()
        .each(Per::body);
  };
  using B = BodyForce;
  const auto torque = [](const FlowSums& s, std::size_t b) { return s.on_bodies.at(b).fluid.torque; };
  return {
      with_bodies(),
      {of("body_force_", "force of the fluid in the last step",
          [](const B& f, std::size_t axis) { return axis == 0 ? f.fluid.x : f.fluid.y; }),
       of("body_hold_", "force of supports and walls in the last step",
          [](const B& f, std::size_t axis) { return f.hold.at(axis); }),
       of("body_change_", "change of the body's momentum by time in it",
          [](const B& f, std::size_t axis) { return f.change.at(axis); }),
       Row("body_torque_z", D::torque, "torque of the fluid's force about the body's centre", torque).each(Per::body)}};
}

Group tracer_column() {
  const auto asked = [](const FlowSetting& s) { return s.with_bodies && s.flow.tracers.count[0] > 0; };
  return {
      {"with immersed bodies and tracers", asked},
      {{"tracers_in_solids", D::number, "tracers inside of solids, which start outside", &FlowSums::tracers_inside}}};
}

}  // namespace

const ColumnTable<FlowSetting, FlowSums>& flow_table() {
  const auto of_bodies = [](const Group& group) { return given<FlowSetting, FlowSums>(with_bodies(), group); };
  static const ColumnTable<FlowSetting, FlowSums> table(
      {energy_columns(), exchange_columns(), fluid_columns(), force_columns(), probe_columns(), difference_columns(),
       body_force_columns(), of_bodies(body_columns()), tracked_columns(), tracer_column(), of_bodies(shape_columns()),
       of_bodies(overlap_columns()), contact_columns()});
  return table;
}

Columns<FlowSums> flow_columns(const Flow& flow, const Solids* solids) {
  const MeshSetting common = solids ? mesh_setting(*solids, region_names(*solids)) : MeshSetting{};
  return {flow_table(), FlowSetting{common, flow, solids != nullptr}};
}

}  // namespace tether::fem
