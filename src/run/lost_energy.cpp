// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/lost_energy.hpp"

#include <fmt/format.h>

#include "results/energy_drift.hpp"

namespace tether {
namespace {

/// Parts of the largest energy exchanged that no deck that comes with the program loses. Of points the nearest is
/// cyl-500-ambient by 0.71, then two-bar by 0.30; of fluids in a box the largest is 0.18.
constexpr double much_of_points = 0.75, much_of_fluids = 0.3;

/// Motions by less than this part of a cell a step are at rest, and what they lose is nothing.
constexpr double resting = 1e-6;

double sum_of_losses(const History& history) {
  double lost = 0;
  for (const Quantity& quantity : history.layout.quantities) {
    if (quantity.book == Book::lost) lost += history.column(quantity.name).back();
  }
  return lost;
}

/// The kinetic energy of all mass next to rest. [energy]
double rest_energy(const Scene& scene, const History& history) {
  const double speed = resting * scene.grid.dx / scene.clock.tstep;
  return 0.5 * history.column("mass").front() * speed * speed;
}

/// The strips beyond open edges lose at their outer ends, and that is no loss of the gas inside.
std::string points_lost(const Scene& scene, const History& history) {
  const double part = energy_lost(history);
  if (scene.edges.any() || part <= much_of_points || sum_of_losses(history) <= rest_energy(scene, history)) return {};
  const bool robust = scene.method.transfer == Transfer::apic;
  return fmt::format(
      "the method itself lost {:.2g} of the largest energy exchanged (columns energy_transfer to energy_contact): the "
      "grid damped the motion, not what the deck describes: use finer cells, more of them across each body{}",
      part, robust ? " and gap" : ", or method='robust' of $mpm");
}

/// Where cells damp the motion that the run is about.
std::string fluid_lost(const History& history) {
  const double part = energy_lost_on_the_way(history);
  if (part <= much_of_fluids) return {};
  return fmt::format(
      "the fluid lost {:.2g} of the largest energy exchanged as it carried its velocity along and as bodies opened and "
      "closed its cells (energy_advected, energy_remeshed): its cells damp the motion as a drag would; finer cells and "
      "shorter steps help, and advection='maccormack'",
      part);
}

}  // namespace

std::string lost_energy_warning(const Scene& scene, const History& history) {
  if (scene.path() == Path::mpm) return points_lost(scene, history);
  return scene.path() == Path::coupled ? fluid_lost(history) : std::string();
}

}  // namespace tether
