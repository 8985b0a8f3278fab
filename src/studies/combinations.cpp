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

Combination on_edge(const Study& study, std::size_t deck, std::size_t axis, std::size_t value, bool others_last) {
  Combination at{deck, std::vector<std::size_t>(study.axes.size())};
  for (std::size_t a = 0; a < study.axes.size(); ++a)
    at.values[a] = study.axes[a].leader == axis ? value : others_last ? study.axes[a].cells.size() - 1 : 0;
  return at;
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

namespace {

/// Makes the search of one deck; a map of one axis is one value high.
BorderSearch search_of(const Study& study) {
  std::array<std::size_t, 2> size{1, 1};
  std::array<bool, 2> ordered{false, false};
  const auto leading = leading_axes(study);
  for (std::size_t k = 0; k < leading.size(); ++k) {
    const auto& cells = study.axes[leading[k]].cells;
    size[k] = cells.size(), ordered[k] = std::holds_alternative<double>(cells.front());
  }
  return {size, ordered, study.coarse};
}

}  // namespace

Sequences::Sequences(const Study& study) : study_(study), numbers_(combinations(study).size(), 0) {
  if (study.bisects())
    bisections_.assign(numbers_.size(), Bisection(study.interval));
  else if (study.mode == Mode::map)
    searches_.assign(study.decks.size(), search_of(study));
}

std::vector<Variant> Sequences::first() {
  std::vector<Variant> wanted;
  for (std::size_t c = 0; c < numbers_.size(); ++c) {
    if (study_.mode == Mode::grid) add(wanted, c, {});
    if (study_.mode == Mode::ensemble) {
      for (const double factor : ensemble_factors(study_.fraction, study_.runs))
        add(wanted, c, study_.own_values[c] * factor);
    }
    if (study_.bisects()) {
      for (const Variant& variant : next(c)) wanted.push_back(variant);
    }
  }
  return searches_.empty() ? wanted : along_borders();
}

std::vector<Variant> Sequences::after(const FinishedRun& run) {
  const std::size_t c = run.variant.combination;
  if (bisections_.empty() && searches_.empty()) return {};
  const auto meets = run.meets(study_.criterion);
  if (!meets) return {};  // a bisection, or a border, stays where it is
  if (!bisections_.empty()) return bisections_[c].take(*run.variant.varied, *meets), next(c);
  const std::size_t squares = numbers_.size() / searches_.size();
  searches_[c / squares].take(c % squares, *meets);
  return along_borders();
}

std::vector<Variant> Sequences::along_borders() {
  std::vector<Variant> wanted;
  const std::size_t squares = numbers_.size() / searches_.size();
  for (std::size_t deck = 0; deck < searches_.size(); ++deck) {
    for (const std::size_t square : searches_[deck].next()) add(wanted, deck * squares + square, {});
  }
  return wanted;
}

std::vector<std::optional<std::size_t>> Sequences::deciding() const {
  std::vector<std::optional<std::size_t>> all;
  for (const BorderSearch& search : searches_) {
    const std::size_t before = all.size();
    for (const auto& by : search.deciding()) all.push_back(by ? std::optional(before + *by) : std::nullopt);
  }
  return all;
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
