// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/sequences.hpp"

namespace tether {

Sequences::Sequences(const Study& study) : study_(study), numbers_(combinations(study).size(), 0) {
  if (study.mode == Mode::bisect) bisections_.assign(numbers_.size(), Bisection(study.interval));
}

std::vector<Variant> Sequences::first() {
  std::vector<Variant> wanted;
  for (std::size_t c = 0; c < numbers_.size(); ++c) {
    if (study_.mode == Mode::grid) add(wanted, c, {});
    if (study_.mode == Mode::ensemble) {
      for (const double factor : ensemble_factors(study_.fraction, study_.runs))
        add(wanted, c, study_.own_values[c] * factor);
    }
    if (study_.mode == Mode::bisect) {
      for (const Variant& variant : next(c)) wanted.push_back(variant);
    }
  }
  return wanted;
}

std::vector<Variant> Sequences::after(const FinishedRun& run) {
  if (study_.mode != Mode::bisect) return {};
  const std::size_t c = run.variant.combination;
  if (!run.decides()) return {};  // the bisection stays where it is
  bisections_[c].take(*run.variant.varied, study_.criterion.holds(run.value(study_.criterion.key)));
  return next(c);
}

std::vector<Variant> Sequences::next(std::size_t combination) {
  std::vector<Variant> wanted;
  for (const double value : bisections_[combination].next()) add(wanted, combination, value);
  return wanted;
}

void Sequences::add(std::vector<Variant>& wanted, std::size_t combination, std::optional<double> varied) {
  wanted.push_back({combination, numbers_[combination]++, varied});
}

}  // namespace tether
