// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/values.hpp"

#include <fmt/format.h>
#include <algorithm>

#include "base/text.hpp"
#include "deck/spelling.hpp"
#include "deck/words.hpp"

namespace tether {

std::shared_ptr<const Expression> expression_of(const Deck& deck, TextVariable name, int k,
                                                std::vector<std::string> variables, Diagnostics& diagnostics) {
  try {
    return std::make_shared<const Expression>(deck.text(name, k), std::move(variables));
  } catch (const ExpressionError& error) {
    diagnostics.add(deck.remark_within(Severity::error, name, {k, 1}, error.at(), error.what(), error.hint()));
    return nullptr;
  }
}

bool has_region(const Deck& deck, int r) {
  if (!deck.given("in.path") || !deck.given("reg.paths", r)) return true;
  const std::vector<std::string> paths = split_words(deck.text("reg.paths", r));
  return std::find(paths.begin(), paths.end(), deck.text("in.path")) != paths.end();
}

std::vector<int> regions_of(const Deck& deck) {
  std::vector<int> regions;
  for (int r = 1; r <= deck.integer("reg.nreg"); ++r) {
    if (has_region(deck, r)) regions.push_back(r);
  }
  return regions;
}

std::vector<int> regions_of(const Deck& deck, bool fluid) {
  std::vector<int> regions = regions_of(deck);
  std::erase_if(regions, [&](int r) { return (deck.text("fem.law", r) == fluid_word) != fluid; });
  return regions;
}

void refuse(const Deck& deck, AnyVariable name, Subscript at, const std::string& message, const std::string& hint,
            Diagnostics& diagnostics) {
  diagnostics.add(deck.remark(Severity::error, name, at, message, hint));
}

bool is_default(const Deck& deck, AnyVariable name, Subscript at) {
  return value_text(deck.value(name, at[0], at[1])) == name.row().fallback;
}

bool has_flow(const Deck& deck) { return deck.has_group("flow") || !regions_of(deck, true).empty(); }

namespace {

namespace fs = std::filesystem;

/// Folders that a relative path climbs above the one it starts from.
int climbs(const fs::path& path) {
  int level = 0, lowest = 0;
  for (const auto& part : path) {
    if (part == "..")
      lowest = std::min(lowest, --level);
    else if (part != "." && !part.empty())
      ++level;
  }
  return -lowest;
}

}  // namespace

std::string path_mistake(const std::string& path) {
  if (fs::path(path).is_absolute()) return "is absolute";
  return climbs(path) > 1 ? "climbs more than one folder" : "";
}

std::string path_hint(const std::string& example) {
  return fmt::format("write a path from the deck's folder, at most one folder up, such as '{}'", example);
}

fs::path path_beside(const Deck& deck, const std::string& name) { return fs::path(deck.file()).parent_path() / name; }

namespace {

/// The group's variables of one table.
struct Named {
  const Deck& deck;
  AnyVariable what;
  int k;
  Diagnostics& diagnostics;

  AnyVariable name(const char* part) const { return what.with(part); }
  void refuse(AnyVariable variable, Subscript at, const std::string& message, const std::string& hint) const {
    diagnostics.add(deck.remark(Severity::error, variable, at, message, hint));
  }
};

/// The times and factors as far as they ascend; what is wrong with them is reported.
Amplitude table_of(const Named& of) {
  const AnyVariable times = of.name("_time"), factors = of.name("_factor");
  const auto number = [&](RealVariable name, int i) { return of.deck.real(name, i, of.k); };
  Amplitude amplitude;
  for (int i = 1; i <= table_count; ++i) {
    const bool time = of.deck.given(times, i, of.k), factor = of.deck.given(factors, i, of.k);
    if (time != factor) {
      of.refuse(time ? times : factors, {i, of.k},
                fmt::format("{}({},{}) is not given", time ? factors : times, i, of.k),
                "each time of a table has its factor");
      return {};
    }
    if (!time) continue;
    if (!amplitude.time.empty() && !(number(times, i) > amplitude.time.back())) {
      of.refuse(times, {i, of.k},
                fmt::format("the times of a table ascend: {:.6g} is not after {:.6g}", number(times, i),
                            amplitude.time.back()),
                "write times and factors in order");
      return {};
    }
    amplitude.time.push_back(number(times, i)), amplitude.factor.push_back(number(factors, i));
  }
  return amplitude;
}

/// A load that comes and goes within one step may never be seen.
void warn_of_short(const Named& of, const Amplitude& amplitude) {
  const double step = of.deck.real("in.tstep");
  if (amplitude.time.size() < 3 || amplitude.factor.front() != amplitude.factor.back() ||
      amplitude.time.back() - amplitude.time.front() >= step)
    return;
  of.diagnostics.add(of.deck.remark(Severity::warning, of.name("_time"), {1, of.k},
                                    fmt::format("{} comes and goes within one step of {:.4g}", amplitude.of, step),
                                    "steps take their loads at their middle or end: lower tstep"));
}

}  // namespace

Amplitude amplitude_of(const Deck& deck, AnyVariable what, int k, Diagnostics& diagnostics) {
  const Named of{deck, what, k, diagnostics};
  Amplitude amplitude = table_of(of);
  amplitude.of = fmt::format("{} {}", what == "fem.fix" ? "support" : what.name(), k);
  warn_of_short(of, amplitude);
  // The sides of a flow have none: their velocities are expressions of time themselves.
  const Variable* formula = find_variable(what.group(), fmt::format("{}_expression", what));
  if (formula && deck.given(AnyVariable(*formula), k)) {
    const TextVariable name{AnyVariable(*formula)};
    if (!amplitude.time.empty())
      of.refuse(name, {k, 1}, fmt::format("{} has a table and an expression", amplitude.of),
                fmt::format("leave {0}_time and {0}_factor away, or this", what));
    amplitude.expression = expression_of(deck, name, k, {"t"}, diagnostics);
  } else if (amplitude.time.empty() && what.group() == "fem" && deck.logical("fem.static")) {
    amplitude.time = {0, deck.real("in.tmax")}, amplitude.factor = {0, 1};
  }
  return amplitude;
}

}  // namespace tether
