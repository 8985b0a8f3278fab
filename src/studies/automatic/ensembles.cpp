// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/automatic/ensembles.hpp"

#include <cmath>

namespace tether::automatic {
namespace {

/// By how much the steps of an ensemble differ from a run's own, on either side.
constexpr double varied_fraction = 0.005;
/// A scatter that is less than this part of the tolerance says nothing.
constexpr double scatter_that_counts = 0.1;
/// What is left of it on finer cells where it is chaos: more than this part.
constexpr double scatter_that_stays = 0.5;

/// Returns how far values lie apart whose steps differ by little: what a straight line through them leaves, since a
/// step that is a little longer has a value that is a little other.
double scatter_of(double shorter, double own, double longer) {
  const double mean = (shorter + own + longer) / 3;
  return mean == 0 ? 0 : std::abs(shorter - 2 * own + longer) / (std::sqrt(6.) * std::abs(mean));
}

}  // namespace

void Ensembles::look(Search& search, double tolerance) {
  if (settled_) return;
  const auto at = search.to_vary();
  if (!at || (first_ > 0 && search.trials().size() < next_look_)) return;
  const double scatter = scatter_at(*at, *search.trials().back().value);
  if (first_ == 0) {
    first_ = scatter, next_look_ = search.trials().size() + 2;
    settled_ = scatter < scatter_that_counts * tolerance;
    return;
  }
  settled_ = true;
  if (scatter > scatter_that_stays * first_) search.take_scatter(scatter);
}

double Ensembles::scatter_at(const Resolution& at, double own) {
  const auto pair = runs_.make({{{at.space, at.time / (1 + varied_fraction)}, left_out_, "scatter"},
                                {{at.space, at.time * (1 + varied_fraction)}, left_out_, "scatter"}});
  if (!pair[0].trial.value || !pair[1].trial.value) return 0;
  return scatter_of(*pair[1].trial.value, own, *pair[0].trial.value);
}

}  // namespace tether::automatic
