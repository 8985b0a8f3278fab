// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/automatic/ensembles.hpp"

#include <algorithm>
#include <cmath>

namespace tether::automatic {
namespace {

/// By how much the steps of an ensemble differ from a run's own, on either side.
constexpr double varied_fraction = 0.005;
/// A scatter that is less than this part of the tolerance says nothing.
constexpr double scatter_that_counts = 0.1;
/// What is left of it on finer cells where it is chaos: more than this part.
constexpr double scatter_that_stays = 0.5;
/// Levels at which it stays, so that it is taken for chaos.
constexpr int looks_at_chaos = 3;

/// Returns how far values lie apart whose steps differ by little: what a straight line through them leaves, since a
/// step that is a little longer has a value that is a little other.
double scatter_of(double shorter, double own, double longer) {
  const double mean = (shorter + own + longer) / 3;
  return mean == 0 ? 0 : std::abs(shorter - 2 * own + longer) / (std::sqrt(6.) * std::abs(mean));
}

}  // namespace

void Ensembles::look(Search& search, const Aim& aim) {
  if (is_settled_ || !aim.theory.time) return;
  const double times = looked_at_ ? 2 : 1;
  const Resolution least = looked_at_.value_or(Resolution{0, 0});
  const auto level = std::ranges::find_if(search.trials(), [&](const Trial& trial) {
    const bool is_finer_in_space = !aim.theory.space || trial.wanted.space >= times * least.space;
    return trial.value && is_finer_in_space && trial.wanted.time >= times * least.time;
  });
  if (level == search.trials().end()) return;
  const double scatter = scatter_at(*level);
  is_settled_ = scatter < scatter_that_counts * aim.tolerance || scatter < scatter_that_stays * before_;
  looked_at_ = level->wanted, before_ = scatter;
  if (is_settled_ || ++looks_ < looks_at_chaos) return;
  is_settled_ = true;
  search.take_scatter(scatter);
}

double Ensembles::scatter_at(const Trial& trial) {
  const auto pair = runs_.make({{trial.wanted, left_out_, Purpose::scatter, 1 / (1 + varied_fraction)},
                                {trial.wanted, left_out_, Purpose::scatter, 1 + varied_fraction}});
  if (!pair[0].value || !pair[1].value) return 0;
  return scatter_of(*pair[0].value, *trial.value, *pair[1].value);
}

}  // namespace tether::automatic
