// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/combinations.hpp"

#include <fmt/format.h>

#include "deck/reader.hpp"

namespace tether {
namespace {

/// One further, the first leading axis fastest; false where all were shown.
bool advance(const Study& study, std::vector<std::size_t>& values) {
  for (std::size_t a = 0; a < values.size(); ++a) {
    if (study.axes[a].leader != a) continue;
    if (++values[a] < study.axes[a].cells.size()) return true;
    values[a] = 0;
  }
  return false;
}

}  // namespace

double count_combinations(const Study& study) {
  auto count = static_cast<double>(study.decks.size());
  for (std::size_t a = 0; a < study.axes.size(); ++a) {
    if (study.axes[a].leader == a) count *= static_cast<double>(study.axes[a].cells.size());
  }
  return count;
}

std::vector<Combination> combinations(const Study& study) {
  std::vector<Combination> all;
  for (std::size_t deck = 0; deck < study.decks.size(); ++deck) {
    std::vector<std::size_t> leading(study.axes.size(), 0);
    do {
      Combination combination{deck, leading};
      for (std::size_t a = 0; a < leading.size(); ++a) combination.values[a] = leading[study.axes[a].leader];
      all.push_back(std::move(combination));
    } while (advance(study, leading));
  }
  return all;
}

std::vector<std::string> overrides_of(const Study& study, const Combination& combination,
                                      std::optional<double> varied) {
  auto overrides = study.sets;
  for (std::size_t a = 0; a < study.axes.size(); ++a) {
    overrides.push_back(study.axes[a].overrides[combination.values[a]]);
  }
  if (varied) overrides.push_back(fmt::format("{}={}", study.vary.variable, *varied));
  return overrides;
}

Deck read_deck(const Study& study, const Combination& combination, std::optional<double> varied) {
  Diagnostics of_the_run;
  const BaseDeck& base = study.decks[combination.deck];
  return read_deck(base.text, base.file, overrides_of(study, combination, varied), of_the_run);
}

std::vector<double> ensemble_factors(double fraction, int runs) {
  std::vector<double> factors(static_cast<std::size_t>(runs));
  for (int k = 0; k < runs; ++k) factors[static_cast<std::size_t>(k)] = 1 + fraction * (2.0 * k / (runs - 1) - 1);
  return factors;
}

}  // namespace tether
