// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "model/coupled.hpp"
#include "physics/box/contact.hpp"
#include "physics/box/liquid/exits.hpp"
#include "physics/box/liquid/particles.hpp"
#include "physics/box/outside.hpp"
#include "physics/box/smoke.hpp"
#include "physics/solids/body_doubts.hpp"
#include "physics/solids/system.hpp"
#include "physics/step_clock.hpp"

namespace tether::coupled {

/// What a box has exchanged since the start: each number is the sum of its own terms, step by step [energy].
struct EnergyBooks {
  // What came in.
  double jets = 0;        ///< by their pressure, and carried in
  double open_sides = 0;  ///< by the pressure outside, on solids, too, and carried in: also from voids
  double gravity = 0;     ///< work of gravity on the fluid
  double buoyancy = 0;    ///< work of smoke and warmth on it
  double loads = 0;       ///< work of loads and moved supports on the solids
  // What went out or became heat.
  double viscous = 0;  ///< what viscosity took
  double damped = 0;   ///< what the solids' damping took
  double contact = 0;  ///< what walls, obstacles and friction took of the solids
  // What the method lost.
  double advected = 0;    ///< as the fluid carried its velocity along
  double remeshed = 0;    ///< as faces opened and closed at moving solids, and small ones took over their neighbours'
  double projected = 0;   ///< by pressures that act a whole step at its end's velocity
  double sources = 0;     ///< by the volume term
  double coupling = 0;    ///< what the fluid gave less what the solids took
  double solid_step = 0;  ///< what the solids' forces took in a step less what is stored of it
};

/// Kinetic energy that velocities carry in a time through the box's openings.
struct CarriedIn {
  double jets = 0, open_sides = 0;  ///< negative: out [energy]
};

/// Through faces of the box's sides, and those to voids, as open sides: rho |v|^2/2 times the flux; along a face the
/// square is the mean of those on both sides of the fluid's cell.
CarriedIn carried_in(const Coupled& scene, const FlowDomain& domain, const FaceValues& v, double h);

/// What one step reports of itself.
struct StepAccount {
  double interface_power = 0;  ///< that the solids take from the fluid, by the solids' equations [power]
  double mismatch = 0;  ///< by the fluid's equations less that, over the sum of the nodes' powers' sizes, at least
                        ///< 1e-3 of the powers in the fluid
  double cfl = 0;       ///< cells that the fluid crosses along an axis where it is fastest
  double gave = 0;      ///< that the fluid gave the solids by pressure and friction [energy]
};

/// All that changes in a run.
struct CoupledState : StepClock {
  FaceValues v;       ///< of the fluid, extended into the solids [velocity]
  FaceValues driven;  ///< of a viscous one's open faces, by pressures and forces in the last step [acceleration]
  FaceValues ended;   ///< what of that the end of the last step was, after pressures [acceleration]
  std::vector<double> driven_nodes;  ///< of nodes that a viscous one sticks to, likewise by all but its friction
  std::vector<double> p;             ///< of each cell, extended into the solids [stress]
  std::vector<double> flow_q;        ///< places of the nodes that the mesh of v and p fits; empty on a grid
  std::vector<double> q, u;          ///< places and velocities of the solids' nodes, dim numbers a node
  std::vector<Touch> touches;        ///< of the nodes, a number a velocity
  std::vector<double> fluid_force,
      wall_force;  ///< on the nodes in the last step, by the fluid, by supports and contact with its friction
  liquid::Particles particles;  ///< of a liquid with a surface
  liquid::LiquidFlow liquid_flow;
  long long full = 1;  ///< 0 once a cell of the room has been empty
  Smoke smoke;
  SmokeFlow smoke_flow;  ///< since the start
  StepAccount last;
  EnergyBooks books;
  double worst_mismatch = 0;   ///< of all steps
  double cfl_largest = 0;      ///< likewise
  double lost_for_good = 0;    ///< by carrying velocities on meshes and by pressures: not given back [energy]
  double work = 0;             ///< that the solids have taken from the fluid [energy]
  long long iterations = 0;    ///< of linear solvers
  long long lu_solutions = 0;  ///< by factors where BiCGSTAB did not converge
  std::vector<double> orders;  ///< of elimination, when the state was saved
  fem::ContactState contact;   ///< of steps that keep the energy
  long long newton_steps = 0, halvings = 0;  ///< of these
  double linear_gain = 0;            ///< most that a linear step gave turning bodies, over their energy of motion
  double unswept = 0;                ///< volume that steps' sweeps left out so far, over that of the bodies
  long long contact_solutions = 0;   ///< solutions found again because of contact
  long long passes = 0;              ///< over friction and pressures, of viscous fluids
  long long unsettled_friction = 0;  ///< steps in which they did not settle
  std::vector<double> swing;         ///< what nodes have more than the mean velocity of the last step [velocity]
  long long calm_steps = 2;          ///< that come now and are calm for it: a flow may begin at once
  long long calmed = 0, swings = 0;  ///< steps that were; those which were found again for it
  long long unmeasured = 0;          ///< 1 once it was reported that a closed volume is not held
  fem::OverlapCount overlap;         ///< of the solids
  std::vector<int> left;             ///< of each body, 1 once it was found to be wholly beyond a side of the box
  long long contact_unsettled = 0;   ///< steps in which the last of them would have been found again, too
  long long narrow_cells = 0;        ///< most in any step that are all of a viscous fluid between two boundaries
  long long thin_cells = 0;          ///< most in any step at which bodies are thinner than a cell, by cut-cell
};

/// Makes a state what it was before a step that is to be found again, but for what finding it has cost.
void go_back(const CoupledState& before, CoupledState& state);

/// The parts of a state for saving and restoring.
template <class Exchange>
void exchange(Exchange& with, CoupledState& state) {
  exchange_clock(with, state);
  with.list("fluid_u", state.v[0]), with.list("fluid_v", state.v[1]), with.list("fluid_w", state.v[2]);
  with.list("driven_u", state.driven[0]), with.list("driven_v", state.driven[1]),
      with.list("driven_w", state.driven[2]);
  with("ended_u", state.ended[0]), with("ended_v", state.ended[1]), with("ended_w", state.ended[2]);
  with("driven_nodes", state.driven_nodes);
  with.list("p", state.p), with.list("flow_q", state.flow_q), with("q", state.q), with("u", state.u),
      with("touches", state.touches);
  with("fluid_force", state.fluid_force), with("wall_force", state.wall_force);
  if (!state.smoke.volume.empty())
    with.list("smoke_volume", state.smoke.volume), with.list("smoke", state.smoke.smoke),
        with.list("heat", state.smoke.heat);
  each_list(state.particles,
            [&](const std::string& name, std::vector<double>& list) { with.list(name.c_str(), list); });
  with("liquid_in", state.liquid_flow.in), with("liquid_out", state.liquid_flow.out);
  with("liquid_owed", state.liquid_flow.owed), with("full", state.full);
  with("smoke_in", state.smoke_flow.smoke_in), with("smoke_out", state.smoke_flow.smoke_out);
  with("heat_in", state.smoke_flow.heat_in), with("heat_out", state.smoke_flow.heat_out);
  with("interface_power", state.last.interface_power), with("mismatch", state.last.mismatch);
  with("worst_mismatch", state.worst_mismatch);
  EnergyBooks& books = state.books;
  with("jets", books.jets), with("open_sides", books.open_sides), with("gravity", books.gravity);
  with("buoyancy", books.buoyancy), with("loads", books.loads), with("viscous", books.viscous);
  with("damped", books.damped), with("contact", books.contact), with("advected", books.advected);
  with("remeshed", books.remeshed), with("projected", books.projected), with("sources", books.sources);
  with("coupling", books.coupling), with("solid_step", books.solid_step);
  with("cfl", state.last.cfl), with("cfl_largest", state.cfl_largest);
  with("lost_for_good", state.lost_for_good), with("work", state.work),
      with("contact_solutions", state.contact_solutions), with("contact_unsettled", state.contact_unsettled),
      with("iterations", state.iterations);
  with("linear_gain", state.linear_gain), with("unswept", state.unswept), with("newton_steps", state.newton_steps),
      with("halvings", state.halvings);
  fem::exchange(with, state.contact), fem::exchange(with, state.overlap);
  with("left", state.left), with("passes", state.passes), with("unsettled_friction", state.unsettled_friction);
  with("swing", state.swing), with("calm_steps", state.calm_steps), with("calmed", state.calmed),
      with("swings", state.swings);
  with("unmeasured", state.unmeasured);
  with("narrow_cells", state.narrow_cells), with("thin_cells", state.thin_cells),
      with("lu_solutions", state.lu_solutions);
  with.list("orders", state.orders);
}

}  // namespace tether::coupled
