// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/limits.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>
#include <algorithm>
#include <initializer_list>
#include <limits>

#include "model/size.hpp"
#include "read/values.hpp"

namespace tether {
namespace {

/// Beyond what the decks here reach where they are right, and before what they were found to reach where they are not.
constexpr Limits default_limits{.quality = {0.1, 0.001},
                                .volume = {0.5, 0.05},
                                .energy_step = {0.5, 100},
                                .energy_growth = {0.05, 100},
                                .splitting = {1, 100},
                                .cfl = {4, 0}};

/// Where the laws of all bodies have no bound on the energy of a volume that vanishes, small volumes grow again, and
/// nothing but a mirrored one is past help.
constexpr double vanishing_quality = 1e-9;

bool all_resist_without_bound(const Solids& solids) {
  return std::ranges::all_of(solids.regions,
                             [](const SolidRegion& region) { return std::holds_alternative<NeoHookean>(region.law); });
}

/// Reads one limit; `low` says that smaller numbers are worse.
Limit limit_of(const Deck& deck, AnyVariable name, Limit limit, bool low, Diagnostics& diagnostics) {
  if (deck.given(name, 1)) limit.warn = deck.real(name, 1);
  if (deck.given(name, 2)) limit.stop = deck.real(name, 2);
  const bool wrong = limit.warn != 0 && limit.stop != 0 && (low ? limit.stop > limit.warn : limit.stop < limit.warn);
  if (wrong)
    diagnostics.add(
        deck.remark(Severity::error, name, {deck.given(name, 2) ? 2 : 1, 1},
                    fmt::format("{}: the run stops at {:.6g}, before it warns at {:.6g}", name, limit.stop, limit.warn),
                    "the first number warns, the second stops; 0 switches off"));
  return limit;
}

}  // namespace

Limits limits_of(const Deck& deck, const Solids* solids, Diagnostics& diagnostics) {
  Limits limits = default_limits;
  if (solids && all_resist_without_bound(*solids)) limits.quality.stop = vanishing_quality;
  const auto read = [&](AnyVariable name, Limit& limit, bool low) {
    limit = limit_of(deck, name, limit, low, diagnostics);
  };
  read("limits.quality", limits.quality, true);
  read("limits.volume", limits.volume, true);
  read("limits.energy_step", limits.energy_step, false);
  read("limits.energy_growth", limits.energy_growth, false);
  read("limits.splitting", limits.splitting, false);
  read("limits.cfl", limits.cfl, false);
  return limits;
}

namespace {

/// Part of the memory that a run may take.
constexpr double usable = 0.8;

/// Returns the memory of the machine, or what the shell allows this process where that is less.
double memory_there() {
  const double physical = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return physical;
  return std::min(physical, static_cast<double>(limit.rlim_cur));
}

}  // namespace

std::string memory_refusal(const BackgroundGrid& grid, double points) {
  const double nodes = static_cast<double>(grid.nx) * static_cast<double>(grid.ny);
  const double bytes = nodes * bytes_per_node + points * bytes_per_point;
  const double there = usable * memory_there();
  const double most = std::numeric_limits<int>::max();
  if (bytes <= there && nodes <= most && points <= most) return "";
  return fmt::format("{} x {} nodes and {:.3g} points would need {:.4g} GB of memory, and {:.4g} GB can be used",
                     grid.nx, grid.ny, points, 1e-9 * bytes, 1e-9 * there);
}

std::string memory_refusal(const StaggeredGrid& grid) {
  const double cells = static_cast<double>(grid.n[0]) * static_cast<double>(grid.n[1]) * static_cast<double>(grid.n[2]);
  const double bytes = cells * bytes_per_cell, there = usable * memory_there();
  if (bytes <= there && 4 * cells <= std::numeric_limits<int>::max()) return "";
  return fmt::format("{} x {} x {} cells would need {:.4g} GB of memory, and {:.4g} GB can be used", grid.n[0],
                     grid.n[1], grid.n[2], 1e-9 * bytes, 1e-9 * there);
}

namespace {

/// Records of a history whose interval the deck does not give.
constexpr double default_records = 200;

/// The shortest interval of the switches that are on; 0 where none is.
double shortest(const Deck& deck, std::initializer_list<int> switches, Diagnostics& diagnostics) {
  double interval = 0;
  for (const int k : switches) {
    if (deck.integer("in.iout", k) != 1) continue;
    if (!deck.given("in.tiout", k)) {
      diagnostics.add(deck.remark(Severity::error, "in.iout", {k, 1},
                                  fmt::format("iout({})=1 needs its interval tiout({})", k, k), "give it, or write 0"));
      continue;
    }
    const double given = deck.real("in.tiout", k);
    if (interval == 0 || given < interval) interval = given;
  }
  return interval;
}

/// Switches that are on but write nothing: numbers without a meaning.
void warn_of_idle_switches(const Deck& deck, Diagnostics& diagnostics) {
  for (const Subscript at : deck.given_elements("in.iout")) {
    const int k = at[0];
    const bool writes = k == 13 || (k >= 30 && k <= 41);
    if (writes || deck.integer("in.iout", k) != 1) continue;
    diagnostics.add(deck.remark(Severity::warning, "in.iout", at, fmt::format("iout({})=1 writes nothing", k),
                                "13 and 30 to 41 have a meaning"));
  }
}

}  // namespace

OutputIntervals outputs_of(const Deck& deck, const Scene& scene, Diagnostics& diagnostics) {
  OutputIntervals outputs;
  warn_of_idle_switches(deck, diagnostics);
  outputs.history = shortest(deck, {33, 34, 38}, diagnostics);
  outputs.points = shortest(deck, {13, 32, 35, 36, 40}, diagnostics);
  outputs.grid = shortest(deck, {30, 31, 37, 39}, diagnostics);
  outputs.checkpoint = shortest(deck, {41}, diagnostics);
  outputs.vtk = word<VtkFiles>(deck, "in.vtk");
  if (outputs.history == 0) outputs.history = scene.clock.tmax / default_records;
  outputs.tracked_angle = deck.integer("in.iout", 38) == 1 && scene.tracked.size() >= 2;
  return outputs;
}

}  // namespace tether
