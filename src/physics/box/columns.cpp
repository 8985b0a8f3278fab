// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/columns.hpp"

#include <cmath>

namespace tether::coupled {
namespace {

using Row = Column<CoupledSetting, CoupledSums>;
using Group = ColumnGroup<CoupledSetting, CoupledSums>;
using Given = When<CoupledSetting>;
using D = Dimension;

const Given& with_solids() {
  static const Given when("with solids", [](const CoupledSetting& s) { return s.with_solids; });
  return when;
}

Group fluid_columns() {
  const auto momentum = [](const CoupledSums& s, std::size_t axis, std::size_t) { return s.momentum[axis]; };
  return {{{"energy_fluid", D::energy, "kinetic energy of the fluid, part of energy_kinetic", &CoupledSums::fluid},
           {"mass", D::mass, "mass of fluid and solids", &CoupledSums::mass},
           Row("momentum_", D::momentum, "momentum of fluid and solids", momentum).vector(),
           {"fluid_volume", D::volume,
            "volume of the fluid, by its cells; by cut-cell also by parts of them; of a liquid what its surface, walls "
            "and bodies enclose",
            &CoupledSums::fluid_volume},
           {"interface_power", D::power, "power that the solids took from the fluid in the last step",
            [](const CoupledSums& s) { return s.state.last.interface_power; }},
           {"interface_work", D::energy, "energy that the solids have taken from the fluid",
            [](const CoupledSums& s) { return s.state.work; }},
           {"interface_mismatch", D::number,
            "power that the fluid gave less that which the solids took in the last step, over the sum of its parts' "
            "sizes, at least a thousandth of the powers in the fluid",
            [](const CoupledSums& s) { return s.state.last.mismatch; }}}};
}

Row booked(const char* name, Book book, const char* meaning, double EnergyBooks::*amount) {
  return Row(name, D::energy, meaning, [amount](const CoupledSums& s) { return s.state.books.*amount; }).booked(book);
}

Group book_columns() {
  using enum Book;
  using B = EnergyBooks;
  return {
      {booked("energy_jets", gained, "work of the pressure at jets, and kinetic energy that they carried in", &B::jets),
       booked("energy_open", gained,
              "work of the pressure outside at open sides, on bodies beyond them, too, and at voids, and kinetic "
              "energy that they "
              "carried in",
              &B::open_sides),
       booked("energy_gravity", gained, "work of gravity on the fluid, which has no energy of gravity in the total",
              &B::gravity),
       booked("energy_buoyancy", gained, "work of smoke and warmth on the fluid", &B::buoyancy),
       booked("energy_outside", gained, "work of loads and moved supports on the solids", &B::loads),
       booked("energy_viscous", given, "energy that viscosity turned into heat", &B::viscous),
       booked("energy_damped", given, "energy that damping and backward Euler have taken", &B::damped),
       booked("energy_contact", given, "what walls, obstacles and friction took of the solids, of linear steps",
              &B::contact)
           .when("without contact that keeps the energy", [](const CoupledSetting& s) { return s.meets ? 0 : 1; }),
       booked("energy_advected", lost, "kinetic energy lost as the fluid carries its velocity along", &B::advected),
       booked("energy_remeshed", lost,
              "kinetic energy lost as solids open and close faces, and small faces take over the speed of those around",
              &B::remeshed),
       booked("energy_projected", lost, "kinetic energy that pressures and forces took by acting at a step's end",
              &B::projected),
       booked("energy_sources", lost, "what the volume term took, less what it gave", &B::sources),
       booked("energy_coupling", lost,
              "what the fluid gave the solids less what they took: it sees their velocity at the step's end, and they "
              "move by the mean of both ends'",
              &B::coupling),
       booked("energy_solid_step", lost,
              "work of the solids' own forces less what is stored of it, which is what the paper's step damps",
              &B::solid_step)}};
}

Group step_columns() {
  return {{{"energy_pressure", D::energy,
            "pressure of a fluid at rest, by its depth, times its volume: what rounding and settling at rest are small "
            "against",
            &CoupledSums::pressure_energy},
           {"cfl", D::number, "cells that the fluid crossed along an axis where it was fastest, in the last step",
            [](const CoupledSums& s) { return s.state.last.cfl; }},
           {"regions", D::number, "parts of the fluid that nothing joins", &CoupledSums::regions},
           {"solver_iterations", D::number, "iterations of linear solvers since the start",
            [](const CoupledSums& s) { return s.state.iterations; }}}};
}

Group smoke_columns() {
  return {{"with smoke", [](const CoupledSetting& s) { return s.with_smoke; }},
          {{"smoke_mass", D::volume, "density of smoke times volume", &CoupledSums::smoke_mass},
           {"smoke_in", D::volume, "smoke that jets have brought, and fluid from outside",
            [](const CoupledSums& s) { return s.state.smoke_flow.smoke_in; }},
           {"smoke_out", D::volume, "smoke that has left",
            [](const CoupledSums& s) { return s.state.smoke_flow.smoke_out; }},
           {"smoke_largest", D::number, "largest density of smoke", &CoupledSums::smoke_largest}}};
}

Group liquid_columns() {
  const auto place = [](const CoupledSums& s, std::size_t axis, std::size_t) { return s.liquid.middle[axis]; };
  const auto velocity = [](const CoupledSums& s, std::size_t axis, std::size_t) { return s.liquid.velocity[axis]; };
  return {{"with a liquid", [](const CoupledSetting& s) { return s.with_liquid; }},
          {{"liquid_particles", D::number, "particles of the liquid",
            [](const CoupledSums& s) { return static_cast<double>(s.liquid.particles); }},
           {"liquid_volume", D::volume, "volume of the liquid: that of its particles, none of which is lost",
            [](const CoupledSums& s) { return s.liquid.volume; }},
           {"liquid_in", D::volume, "volume that jets have brought in",
            [](const CoupledSums& s) { return s.state.liquid_flow.in; }},
           {"liquid_out", D::volume, "volume that has left through openings and jets",
            [](const CoupledSums& s) { return s.state.liquid_flow.out; }},
           {"surface_area", D::area, "area of the liquid's surface to the air",
            [](const CoupledSums& s) { return s.liquid.area; }},
           Row("liquid_", D::length, "middle of the liquid", place).vector(),
           Row("liquid_v", D::velocity, "mean velocity of the liquid", velocity).vector()}};
}

Group sheet_columns() {
  const auto meaning = [](const CoupledSetting& s, std::size_t k) {
    return s.first_volumes[k] < 0 ? "volume of a cavity in the solids"
                                  : "volume that an outer surface of the solids encloses";
  };
  return numbered<CoupledSetting, CoupledSums>(
      {{"with solids", [](const CoupledSetting& s) { return s.with_solids ? s.first_volumes.size() : 0; }},
       {Row("volume_sheet", D::volume, "volume that an outer surface of the solids, or a cavity in them, encloses",
            [](const CoupledSums& s, std::size_t k) { return std::abs(s.sheets.at(k)); })
            .meaning_of(meaning)}});
}

Group force_columns() {
  const auto force = [](const CoupledSums& s, std::size_t axis, std::size_t b) { return s.force.at(b)[axis]; };
  const auto hold = [](const CoupledSums& s, std::size_t axis, std::size_t b) { return s.hold.at(b)[axis]; };
  return {with_solids(),
          {Row("body_force_", D::force, "force of the fluid in the last step", force).vector().each(Per::body),
           Row("body_hold_", D::force, "force of supports and walls in the last step", hold).vector().each(Per::body)}};
}

}  // namespace

const ColumnTable<CoupledSetting, CoupledSums>& coupled_table() {
  const auto of_solids = [](const Group& group) { return given<CoupledSetting, CoupledSums>(with_solids(), group); };
  static const ColumnTable<CoupledSetting, CoupledSums> table(
      {energy_columns(), fluid_columns(), book_columns(), step_columns(), smoke_columns(), liquid_columns(),
       of_solids(fem::shape_columns()), of_solids(fem::overlap_columns()), fem::contact_columns(), sheet_columns(),
       force_columns(), of_solids(body_columns()), tracked_columns()});
  return table;
}

}  // namespace tether::coupled
