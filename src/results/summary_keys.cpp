// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/summary_keys.hpp"

#include <fmt/format.h>

#include "base/file.hpp"
#include "base/text.hpp"

namespace tether {
namespace {

/// Sides in force_on of $flow.
constexpr int force_side_count = 10;

/// What results/compare_*.cpp tell of: profiles by their error alone.
std::vector<std::string> merit_keys(ReferenceKind reference) {
  std::vector<std::string> names;
  switch (reference) {
    case ReferenceKind::riemann:
      return {"error_density",         "error_velocity", "error_pressure",
              "error_specific_energy", "compared_from",  "compared_to"};
    case ReferenceKind::spring:
      names = {"period", "largest_drop"};
      break;
    case ReferenceKind::string:
      names = {"taut_time", "largest_drop", "slack_again_time", "apex_time"};
      break;
    case ReferenceKind::pendulum:
    case ReferenceKind::piston:
      names = {"period"};
      break;
    case ReferenceKind::radial_gas:
      names = {"rms_radius", "radius_95"};
      break;
    case ReferenceKind::thin_ring:
      names = {"radius_x", "radius_y", "pressure", "stress"};
      break;
    case ReferenceKind::none:
      break;
  }
  std::vector<std::string> keys;
  for (const auto& name : names) keys.insert(keys.end(), {name, "exact_" + name, "error_" + name});
  return keys;
}

}  // namespace

std::vector<std::string> summary_keys(ReferenceKind reference) {
  std::vector<std::string> keys{"path",
                                "steps",
                                "points",
                                "cells_active",
                                "dx",
                                "time_end",
                                "dt_min",
                                "cpu_seconds",
                                "wall_seconds",
                                "setup_cpu_seconds",
                                "setup_wall_seconds",
                                "ns_per_point_step",
                                "peak_memory_mb",
                                "energy_drift",
                                "energy_lost",
                                "energy_growth",
                                "energy_rise",
                                "mass_drift",
                                "energy_step_largest"};
  for (auto& key : merit_keys(reference)) keys.push_back(std::move(key));
  return keys;
}

std::vector<std::string> string_summary_keys() { return {"widest_gap"}; }

std::vector<std::string> gas_summary_keys() { return {"gases_apart", "gas_leaked"}; }

std::vector<std::string> solid_points_summary_keys() { return {"volume_worst", "points_apart"}; }

std::vector<std::string> mesh_summary_keys() {
  return {"unknowns",
          "newton_iterations",
          "halvings",
          "factor_nonzeros",
          "assembly_cpu_seconds",
          "assembly_wall_seconds",
          "solve_cpu_seconds",
          "solve_wall_seconds",
          "analysis_cpu_seconds",
          "analysis_wall_seconds"};
}

std::vector<std::string> locking_summary_keys() { return {"elements_across", "bending_too_stiff"}; }

std::vector<std::string> residual_summary_keys() { return {"equilibrium_residual", "steady_residual"}; }

std::vector<std::string> momentum_summary_keys() { return {"momentum_drift", "angular_momentum_drift"}; }

std::vector<std::string> body_summary_keys() { return {"nodes_inside", "quality_least", "volume_worst"}; }

std::vector<std::string> flow_summary_keys() { return {"factorisations", "krylov_iterations", "krylov_failures"}; }

std::vector<std::string> coefficient_summary_keys() {
  std::vector<std::string> keys;
  for (int k = 1; k <= force_side_count; ++k)
    keys.insert(keys.end(), {fmt::format("drag_{}", k), fmt::format("lift_{}", k)});
  return keys;
}

std::vector<std::string> coupled_summary_keys() {
  return {"krylov_iterations",  "lu_solutions",     "contact_solutions", "contact_unsettled",
          "cfl_largest",        "thin_cells",       "bodies_left",       "bodies_slip",
          "interface_mismatch", "added_mass_ratio", "obstacle_volume",   "void_volume"};
}

Summary read_summary(const std::filesystem::path& path) {
  Summary summary;
  for (const auto& line : split_lines(read_file(path))) {
    const auto equals = line.find(" = ");
    if (line.starts_with('#') || equals == std::string::npos) continue;
    summary.emplace_back(line.substr(0, equals), line.substr(equals + 3));
  }
  return summary;
}

}  // namespace tether
