// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "base/warned.hpp"
#include "loops/points.hpp"
#include "loops/thread_team.hpp"
#include "model/scene.hpp"
#include "physics/points/arrays.hpp"
#include "physics/points/balance.hpp"
#include "physics/points/blocks.hpp"
#include "physics/points/contact.hpp"
#include "physics/points/density.hpp"
#include "physics/points/elements.hpp"
#include "physics/points/lanes/work.hpp"
#include "physics/points/normals.hpp"
#include "physics/points/strips.hpp"
#include "physics/step_clock.hpp"
#include "results/results.hpp"

namespace tether::mpm {

/// What a run of points warns of, each once: points of a solid or of a string stand too far apart, an end of a string
/// comes off its wall, gases of unlike energy share a cell, gas seeps through a membrane, steps are shorter than the
/// deck's.
enum class PointDoubt { apart, gap, end, mixing, leak, limit };

/// What a step remembers in single numbers beside the clock's. A number is a member and its row.
struct StateNumbers {
  double gas_mass = 0;                 // [mass]
  double heat_given = 0;               // to the gas by the ledger since the start [energy]
  double heat_under_way = 0;           // of it, what the gas takes in the next step [energy]
  double heat_for_all = 0;             // of it, what goes to all gas alike [energy]
  double c_max = 0;                    // largest sound speed of the gas after the last step [velocity]
  double wave_max = 0;                 // its largest c + |v| [velocity]
  long long crossings_since_sort = 0;  // of points, from cell to cell
  double widest_gap = 0;               // of neighbours of a string or membrane since the start [cells]
  double points_apart = 0;             // of neighbours of a solid that carries F since the start, as looked at [cells]
  double gases_apart = 1;              // largest ratio of pressures of gases in one cell since the start
  long long gas_leaked = 0;            // points of gas beyond a membrane that parts the grid, at the last look
  double carried_at_start = 0;  // APIC: kinetic energy of points that run by lanes; records see the rest [energy]
  long long warned = 0;         // of which doubts
  long long point_steps = 0;

  /// Name in a checkpoint, and member.
  static constexpr auto rows() {
    using N = StateNumbers;
    return std::tuple{
        NumberField{"gas_mass", &N::gas_mass},
        NumberField{"heat_given", &N::heat_given},
        NumberField{"heat_under_way", &N::heat_under_way},
        NumberField{"heat_for_all", &N::heat_for_all},
        NumberField{"c_max", &N::c_max},
        NumberField{"wave_max", &N::wave_max},
        NumberField{"crossings_since_sort", &N::crossings_since_sort},
        NumberField{"widest_gap", &N::widest_gap},
        NumberField{"points_apart", &N::points_apart},
        NumberField{"gases_apart", &N::gases_apart},
        NumberField{"gas_leaked", &N::gas_leaked},
        NumberField{"carried_at_start", &N::carried_at_start},
        NumberField{"warned", &N::warned},
        NumberField{"point_steps", &N::point_steps},
    };
  }
};
/// How points run that may run by lanes: by which instructions and on how many threads, or not at all.
struct LaneChoice {
  InstructionSet set = instruction_set();
  bool on = true;
  int threads = 1;
};

/// All that changes while a scene runs.
struct State : StateNumbers, StepClock {
  Points points;
  Grid grid;
  std::vector<Slots> ranges;        // slots of each body
  std::vector<char> has_pins;       // of each body
  bool pins_hold_loads = false;     // elements make the forces of membranes: pinned points give the nodes nothing
  std::vector<Slots> gas;           // slots of the gas bodies
  std::vector<Slots> gas_by_cells;  // of those that take their density from cells
  std::vector<Slots> fluids;        // all fluids, where normals ask for them
  std::vector<Slots> gas_by_nodes;  // and from nodes
  std::optional<MembraneNormals> normals;            // where tangents come from, unless from connectivity
  std::vector<double> old_tx, old_ty;                // room for the tangents of before
  std::optional<CellDensity> density;                // where the gas takes its density from cells
  std::vector<std::optional<Elements>> elements_of;  // of each body: its elements, where they make its forces
  std::vector<std::optional<Elements>> ambient_of;   // of each body: where only the pressure outside needs them
  Strips strips;                                     // of gas beyond open edges
  Contact contact;                                   // of bodies that share nodes
  bool keeps_ledger = false;                         // of heat that transfers and elements lose
  Balance balance;                                   // of energy
  std::vector<std::optional<Blocks>> blocks;         // of each body whose points run by lanes
  std::size_t empty_slots = 0;                       // slots that hold no point
  std::optional<LanePasses> lane_passes;             // where some do
  std::vector<LaneFindings> lane_findings;           // of the last pass, for each strip
  std::vector<LaneTotals> node_findings;             // of the last solve, for each piece of the nodes
  std::unique_ptr<Team> team;                        // of threads
  double light_node = 0;                             // mass of which no motion is, for the balance [mass]

  /// `given` is empty then.
  State(const Scene& scene, PointSet& given, const LaneChoice& lanes)
      : points(scene, given),
        grid(scene, lanes.set),
        strips(scene, points),
        contact(scene, points, grid.frame),
        team(std::make_unique<ThreadTeam>(lanes.threads)) {}

  std::size_t point_count() const { return points.size() - empty_slots; }
  /// Returns what strips change of it.
  BodyPoints body_points() { return {points, ranges}; }
  /// New tangents of membrane b by the scene's rule, and the total strain's component along them (5.3).
  void turn_tangents(const Scene& scene, std::size_t b);
  /// The lists of gases and fluids, and the mass of all gas, from the present ranges.
  void list_fluids(const Scene& scene);
  /// New tangents alone; those of before say which way they run.
  void find_tangents(std::size_t b);
};

/// The state at time 0: densities, stresses and tangents from what the scene says, and the first map to the grid (step
/// 1 of the algorithm), so that every step begins with its sums in place.
State start(const Scene& scene, const LaneChoice& lanes = {});
/// Does the same with the scene's points apart from it, which are gone then.
State start(const Scene& scene, PointSet points, const LaneChoice& lanes = {});

/// Sorts the slots of all bodies that do not stand in blocks, but for strings, which keep the order of their file: it
/// runs along them.
void sort_bodies(CellSort& sort, State& state, const Scene& scene);

/// Returns whether heat is booked: the method says so and there is gas, with its density from nodes, to take it.
bool keeps_ledger(const Scene& scene);

/// The state as plain data, and back into a state of the same scene, to the last bit: sums at nodes are kept as they
/// are, since points that were sorted meanwhile would add up to others. Scratch arrays are left out, and which nodes
/// are active, which the caller lists. restore() throws FileError.
SavedState save(const State& state);
void restore(State& state, const Scene& scene, const SavedState& saved);

}  // namespace tether::mpm
