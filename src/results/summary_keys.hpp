// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/numbers.hpp"
#include "model/scene.hpp"
#include "results/results.hpp"

namespace tether {

/// Sets of kinds of runs.
namespace runs_of {
constexpr unsigned points = 1, bars = 2, solids = 4, rigid = 8, flows = 16, boxes = 32;
constexpr unsigned meshes = solids | rigid | flows;
constexpr unsigned bodies = solids | flows | boxes;  ///< that may have elastic bodies of elements
constexpr unsigned all = points | bars | solids | rigid | flows | boxes;
}  // namespace runs_of

/// A key of summary.txt: the runs that may write it, and what it says.
struct SummaryRow {
  std::string_view name;
  unsigned of;
  Dimension dimension;
  std::string_view meaning;
  std::string_view when = {};  ///< empty: always
};

/// THE list of keys, but for figures of merit and those of sides (drag_1, lift_1 ...).
inline constexpr auto summary_rows = [] {
  using namespace runs_of;
  using enum Dimension;
  constexpr std::string_view motion = "not of equilibria and steady flows";
  constexpr std::string_view newton = "not of linear steps in a box";
  constexpr std::string_view meets = "`$contact`, or steps that keep the energy in a box with contact";
  return std::array{
      SummaryRow{"path", all, number, "method: mpm, fem or coupled"},
      SummaryRow{"steps", all, number, "steps taken"},
      SummaryRow{"points", all, number, "points, nodes, or of a box cells and nodes; of a rigid body 1"},
      SummaryRow{"cells_active", all, number, "cells with points or fluid at the end, or elements"},
      SummaryRow{"dx", all, length, "a cell's length along x"},
      SummaryRow{"time_end", all, time, "time at the end"},
      SummaryRow{"dt_min", all, time, "shortest step but for one cut by the end"},
      SummaryRow{"cpu_seconds", all, number, "seconds of the processor; they add up over restarts, as those below"},
      SummaryRow{"wall_seconds", all, number, "seconds of the clock on the wall"},
      SummaryRow{"setup_cpu_seconds", all, number, "those before the first step: the deck, the scene, first outputs"},
      SummaryRow{"setup_wall_seconds", all, number, "the same of the clock on the wall"},
      SummaryRow{"threads", all, number, "threads that shared the work"},
      SummaryRow{"ns_per_point_step", all, number, "nanoseconds of the processor a point and step, without setup"},
      SummaryRow{"peak_memory_mb", all, number, "most memory held at a time, in megabytes"},
      SummaryRow{"energy_drift", all, number,
                 "largest change of the total energy less all that is booked in columns, over what was exchanged",
                 motion},
      SummaryRow{"energy_lost", all, number, "what the method itself lost by the end, over the same", motion},
      SummaryRow{"energy_growth", all, number, "largest size of the total energy over that at the start",
                 "there is energy at the start, more than the rounding of what came from outside"},
      SummaryRow{"energy_rise", all, number, "its largest rise that no exchange explains, over what was exchanged",
                 motion},
      SummaryRow{"mass_drift", all, number, "largest change of the mass, over that at the start"},
      SummaryRow{"energy_step_largest", all, number,
                 "largest rise in one step or between records that no exchange explains, over the largest energy "
                 "before",
                 motion},
      SummaryRow{
          "points_by_lanes", points, number,
          "points at the end that run by lanes, those of eight neighbouring cells at once; the others run one by "
          "one"},
      SummaryRow{"points_of_row", points, number, "points that run, of which each stands for those abreast of it",
                 "`reduce` of `$mpm`"},
      SummaryRow{"compared_from", points, length, "x from which profiles are compared", "of tubes"},
      SummaryRow{"compared_to", points, length, "x to which", "of tubes"},
      SummaryRow{"widest_gap", points, number, "largest distance of neighbours on strings and membranes, in cells",
                 "there are such"},
      SummaryRow{"points_apart", points, number, "largest distance that neighbours were stretched to, in cells",
                 "there are solids whose points carry F"},
      SummaryRow{"gases_apart", points, number, "largest ratio of (gamma - 1) i of two gases in one cell",
                 "density of gases is that of cells"},
      SummaryRow{"gas_leaked", points, number, "points of gas half a cell and more beyond the side that they began on",
                 "gas and membranes that part the grid"},
      SummaryRow{"unknowns", meshes | boxes, number, "unknowns of the linear systems"},
      SummaryRow{"newton_iterations", meshes | boxes, number, "Newton's iterations of all steps", newton},
      SummaryRow{"halvings", meshes | boxes, number, "steps, and parts of steps, that were halved", newton},
      SummaryRow{"factorisations", flows, number, "matrices that were factorised"},
      SummaryRow{"factor_nonzeros", solids | flows | boxes, number, "nonzeros of the factors"},
      SummaryRow{"linear_solver", flows | boxes, number, "how linear systems are solved: direct, krylov, bicgstab"},
      SummaryRow{"krylov_iterations", flows | boxes, number, "iterations of the linear systems, of all steps"},
      SummaryRow{"krylov_failures", flows, number, "linear systems that had to be factorised after all"},
      SummaryRow{"assembly_cpu_seconds", solids | flows, number, "seconds of the processor that matrices took"},
      SummaryRow{"assembly_wall_seconds", solids | flows, number, "the same of the clock on the wall"},
      SummaryRow{"solve_cpu_seconds", solids | flows | boxes, number, "seconds of the processor in linear systems"},
      SummaryRow{"solve_wall_seconds", solids | flows | boxes, number, "the same of the clock on the wall"},
      SummaryRow{"analysis_cpu_seconds", solids | flows, number, "seconds of the processor that orderings took"},
      SummaryRow{"analysis_wall_seconds", solids | flows, number, "the same of the clock on the wall"},
      SummaryRow{"elements_across", bodies, number, "least number of elements across a body", "not of fibres alone"},
      SummaryRow{"bending_too_stiff", bodies, number,
                 "estimate of how much too stiff they are in bending; below 0 they are too soft",
                 "not of fibres alone"},
      SummaryRow{"momentum_drift", solids | rigid, number,
                 "largest change of the momentum since loads are gone, over sqrt(2 m E)", "nothing but loads acts"},
      SummaryRow{"angular_momentum_drift", solids | rigid, number,
                 "that of the angular momentum, over its largest or that moment", "nothing but loads acts"},
      SummaryRow{"equilibrium_residual", solids, number, "largest residual of the equilibria", "static=.true."},
      SummaryRow{"steady_residual", flows, number, "largest residual of the steady flows", "steady=.true."},
      SummaryRow{"steady_rounds", flows, number, "rounds between fluid and bodies", "steady=.true. with bodies"},
      SummaryRow{"nodes_inside", bodies, number, "most nodes inside another body", "there are elastic bodies"},
      SummaryRow{"quality_least", bodies, number, "least volume of an element over that at the start",
                 "there are elastic bodies"},
      SummaryRow{"volume_worst", points | bodies, number,
                 "a body's volume against that at the start, the smaller over the larger, at its worst",
                 "bodies have a law that keeps it"},
      SummaryRow{"nodes_carried", flows, number, "nodes of the fluid's lines that carry bodies", "there are bodies"},
      SummaryRow{"node_spacing", flows, number, "largest distance of these, over the fluid's", "there are bodies"},
      SummaryRow{"cells_across", flows, number, "thickness of the thinnest body in the fluid's cells",
                 "there are bodies"},
      SummaryRow{"mode", boxes, number, "mode of the coupling"},
      SummaryRow{"lu_solutions", boxes, number, "solutions by factors within iterations", "mode='paper'"},
      SummaryRow{"contact_gap", bodies, length, "distance at which surfaces began to press each other", meets},
      SummaryRow{"contact_slid", bodies, number,
                 "farthest way of damped surfaces past each other in a step, over the gap", meets},
      SummaryRow{"contact_euler_steps", bodies, number,
                 "steps by backward Euler since nothing that keeps the energy led on", meets},
      SummaryRow{"contact_eased_steps", bodies, number,
                 "steps in which friction came up at up to a hundred times the speed of stick", meets},
      SummaryRow{"linear_gain", boxes, number, "most that a step gave bodies that turn, over their energy of motion",
                 "steps are linear"},
      SummaryRow{"contact_solutions", boxes, number, "steps' systems that were solved again for contact"},
      SummaryRow{"contact_unsettled", boxes, number, "steps in which 60 such did not settle it"},
      SummaryRow{"friction_passes", boxes, number, "times that steps' friction and pressures were found together",
                 "viscosity > 0"},
      SummaryRow{"friction_unsettled", boxes, number, "steps in which 40 such did not settle them", "viscosity > 0"},
      SummaryRow{"calmed_steps", boxes, number, "steps that end with their mean velocity since bodies would swing",
                 "viscosity > 0, solids keep their energy"},
      SummaryRow{"narrow_cells", boxes, number, "most cells that alone fill a gap, which has too little friction then",
                 "viscosity > 0, flow='mesh'"},
      SummaryRow{"mesh_cells", boxes, number, "triangles or tetrahedra of the fluid at the end", "flow='mesh'"},
      SummaryRow{"mesh_pressures", boxes, number, "pressures that its last step found", "flow='mesh'"},
      SummaryRow{"cfl_largest", boxes, number, "most cells that the fluid crossed in a step"},
      SummaryRow{"thin_cells", boxes, number, "most cells that a body is too thin for", "mode='cut-cell'"},
      SummaryRow{"volume_unswept", boxes, number,
                 "volume of bodies that steps' sweeps left out, over the whole; of boxes with openings"},
      SummaryRow{"bodies_left", boxes, number, "bodies that were found wholly beyond a side of the box"},
      SummaryRow{"bodies_slip", boxes, number, "bodies along which a viscous fluid slips"},
      SummaryRow{"interface_mismatch", boxes, number, "worst mismatch of the power across the interface"},
      SummaryRow{"added_mass_ratio", boxes, number, "largest ratio of added mass to m + c h/2", "mode='splitting'"},
      SummaryRow{"obstacle_volume", boxes, volume, "volume of the cells of obstacles", "there are such"},
      SummaryRow{"void_volume", boxes, volume, "volume of the cells of voids", "there are such"},
  };
}();

/// A figure of merit against an exact solution, with its keys: its name, exact_ and error_; of a profile error_ alone.
struct FigureRow {
  std::string_view name;
  unsigned solutions;  ///< set of bits
  Dimension dimension;
  std::string_view meaning;
  bool profile = false;
};
constexpr unsigned bit(ReferenceKind kind) { return 1U << static_cast<unsigned>(kind); }

/// THE list of figures of merit.
inline constexpr auto figure_rows = [] {
  using enum Dimension;
  using enum ReferenceKind;
  return std::array{
      FigureRow{"density", bit(riemann), Dimension::density,
                "mean distance of the columns of cells from the exact profile", true},
      FigureRow{"velocity", bit(riemann), Dimension::velocity, "the same", true},
      FigureRow{"pressure", bit(riemann), stress, "the same", true},
      FigureRow{"specific_energy", bit(riemann), Dimension::specific_energy, "the same", true},
      FigureRow{"period", bit(spring) | bit(pendulum) | bit(piston), time, "period of the last tracked point"},
      FigureRow{"taut_time", bit(string), time, "when the string becomes taut"},
      FigureRow{"largest_drop", bit(spring) | bit(string), length, "how far the last tracked point falls"},
      FigureRow{"slack_again_time", bit(string), time, "when the string is slack again"},
      FigureRow{"apex_time", bit(string), time, "when the point is highest after that"},
      FigureRow{"rms_radius", bit(radial_gas), length, "root of the mean square of the gas's radii"},
      FigureRow{"radius_95", bit(radial_gas), length, "radius within which 0.95 of the gas is"},
      FigureRow{"radius_x", bit(thin_ring), length, "radius of the ring along x"},
      FigureRow{"radius_y", bit(thin_ring), length, "radius of the ring along y"},
      FigureRow{"pressure", bit(thin_ring), stress, "mean pressure of the gas inside"},
      FigureRow{"stress", bit(thin_ring), stress, "mean stress along the ring"},
  };
}();

/// A name of a list of rows: one without a row does not compile.
template <const auto& rows>
class NameOf {
 public:
  consteval NameOf(const char* name) : name_(row_of(name).name) {}  // NOLINT: written as a text
  /// One that is put together while the program runs. Throws std::logic_error where the list has no such row.
  explicit NameOf(const std::string& name) : name_(row_of(name).name) {}
  std::string text() const { return std::string(name_); }

 private:
  static constexpr const auto& row_of(std::string_view name) {
    for (const auto& row : rows) {
      if (row.name == name) return row;
    }
    throw std::logic_error("the list has no row of that name");
  }
  std::string_view name_;
};
using SummaryKey = NameOf<summary_rows>;
using FigureName = NameOf<figure_rows>;

/// A line of summary.txt.
template <class Value>
std::pair<std::string, std::string> line_of(SummaryKey key, const Value& value) {
  return {key.text(), fmt::format("{}", value)};
}

/// The keys that runs of these kinds may write, and those of sides where there are flows.
std::vector<std::string> summary_keys(unsigned of);
/// The keys of figures of merit against this solution, in order.
std::vector<std::string> figure_keys(ReferenceKind reference);

/// The list in words, or as the table of the guides.
std::string keys_listing();
std::string keys_markdown();

/// summary.txt, or another file of lines `key = value` and remarks `# ...`; other lines are passed over. Throws
/// FileError where it cannot be read.
Summary read_summary(const std::filesystem::path& path);

}  // namespace tether
