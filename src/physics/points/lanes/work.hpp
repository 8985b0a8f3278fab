// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "grid/boxes.hpp"
#include "loops/instruction_set.hpp"
#include "model/method.hpp"
#include "physics/points/blocks.hpp"

namespace tether::mpm {

// What passes by lanes work on: plain numbers and places of arrays, so that one text of a pass serves every
// instruction set.

/// The arrays of the points, the body's first slot first; null where the scene has none of them.
struct LanePoints {
  double *x, *y, *vx, *vy, *vxx, *vyx, *vxy, *vyy;
  const double *mass, *volume;
  double *sxx, *syy, *sxy, *szz, *rho, *energy;
  double *dxx, *dyy, *dxy, *dzz;  // of laws that wait for their neighbours' new places
};

/// Rows of the nodes, node 0 first: what points read, and what they add to.
struct LaneNodes {
  const double *old_x, *old_y;  // velocity before the solve, or the convected one
  const double *new_x, *new_y;  // velocity after it
  const double *a_x, *a_y;      // acceleration
  const double *rho, *heat;     // density of the gas, and the ledger's heat for it
  const double* squares;        // of the ledger
  double *m, *gas, *momentum_x, *momentum_y, *force_x, *force_y, *loss, *convected_x, *convected_y;
};

/// Where cells are: of a place x the cell is (x - x0) per_dx. [length, 1/length]
struct LaneGrid {
  double x0, y0, per_dx, per_dy;
  std::ptrdiff_t nx;  // nodes of a row
};

/// A point that has left its cell and given nothing to nodes yet.
struct Moved {
  std::size_t slot;
  Blocks::Cell cell;  // that it has left
  double lost;        // what the ledger booked of it [energy]
};

/// What a pass finds in a strip: sums, a number a lane, and who has left.
struct LaneFindings {
  static constexpr std::size_t lanes = Blocks::lanes, none = static_cast<std::size_t>(-1);
  double squares[lanes] = {};  // FLIP: as StepFindings::squares
  double lifted[lanes] = {};   // as StepFindings::lifted
  double heat[lanes] = {};     // as StepFindings::heat
  double c_squared = 0;        // largest
  double wave = 0;             // largest
  std::size_t unsound = none;  // first slot whose numbers are none any more
  std::vector<Moved> moved;
  std::vector<double> numbers;  // of the first of them, one from each of LaneWork::arrays

  /// Of so many points the numbers are noted while they are at hand; a body that changes its cells as a whole would
  /// need as much room for them again as it has.
  static constexpr std::size_t most_noted = 1024;

  /// Nothing is found yet; the lists keep their room.
  void begin() {
    LaneFindings fresh;
    std::swap(fresh.moved, moved), std::swap(fresh.numbers, numbers);
    fresh.moved.clear(), fresh.numbers.clear();
    *this = std::move(fresh);
  }
};

/// Laws that run by lanes; gas by where its density comes from: the nodes, continuity, or its array, where it stands.
/// The others are asked point by point.
enum class LaneLaw { elastic, gas_of_nodes, gas_of_continuity, gas_of_cells, one_by_one };
constexpr std::size_t lane_laws = 5;
constexpr bool is_gas(LaneLaw law) { return law != LaneLaw::elastic && law != LaneLaw::one_by_one; }

/// Strain rate of a point and its spin [1/time].
struct PointRate {
  double xx, yy, xy, zz, spin;
};
/// A law that is asked point by point.
struct LawOfPoints {
  /// Updates slot p, counted from the body's first one, and returns the volume in which its stress pulls; notes
  /// wave speeds and who is unsound.
  double (*update)(const void* law, std::size_t p, const PointRate& rate, LaneFindings& found) = nullptr;
  const void* law = nullptr;
};

/// What is the same for all points of a body in a step.
struct LaneBody {
  LaneLaw law = LaneLaw::elastic;
  double own = 0, other = 0, shear = 0;  // elastic: sxx' = own dxx + other dyy, sxy' = shear dxy [stress]
  double gm1 = 0, gamma = 0;             // gas: gamma - 1 and gamma
  double linear = 0, square = 0;         // gas: c_1 g [length], c_2 g^2 [length^2] of the artificial viscosity
  double mu = 0;                         // gas: viscosity [stress time]
  bool local_speed = true;               // gas: its viscosity takes the sound speed of its place
  double c_max = 0;                      // else this one [velocity]
  bool heats = false;                    // gas: heated by the rate that makes the stress
  double heat = 0;                       // gas: of the ledger for all gas [energy/mass]
  LawOfPoints each = {};                 // one by one
};

/// All that a pass has to know.
struct LaneWork {
  LanePoints P;
  LaneNodes N;
  LaneGrid grid;
  const Blocks* blocks;
  LaneBody body;
  std::span<double* const> arrays = {};  // all that go with a point, the body's first slot first
  double dt = 0;
  bool about_axis = false;
  bool records = false;       // velocities and fields about points are written, which the grid has else
  bool reads_stress = false;  // usf: the stress of gas is read before the points move
};

/// The passes over a strip of a body's rows, one table for each instruction set, with what the scheme's order asks for;
/// the one by law has it as LaneLaw counts. Strips of one round may be swept at the same time.
struct LanePasses {
  using Pass = void (*)(const LaneWork& work, Blocks::Strip strip, LaneFindings& found);
  /// musl: velocities (3.22), and their momenta back on the nodes (3.24).
  Pass accelerate_and_convect = nullptr;
  /// musl and usl: strain rate (3.23), of usl velocities (3.22), places (3.21), stress, the map (3.15), (3.16).
  Pass strain_move_and_map = nullptr;
  /// The same in two: strain rate, velocities, places; then stress and the map, once neighbours stand at their places.
  Pass strain_and_move = nullptr;
  Pass stress_and_map = nullptr;
  /// usf: strain rate (3.23), stress, force (3.16); the points stay.
  Pass strain_and_pull[lane_laws] = {};
  /// usf: velocities (3.22), places (3.21), heat of gas (4.10), mass and momentum (3.15).
  Pass accelerate_move_and_map = nullptr;
  /// The same with the ledger's books.
  Pass accelerate_book_move_and_map = nullptr;
};

/// Returns the passes of a method's kernel, transfer and order.
LanePasses lane_passes(InstructionSet set, const Method& method, Geometry geometry);

}  // namespace tether::mpm
