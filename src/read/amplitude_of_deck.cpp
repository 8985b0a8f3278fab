// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "read/amplitude_of_deck.hpp"
#include "read/expression_of_deck.hpp"

namespace tether {
namespace {

/// The group's variables of one table.
struct Named {
  const Deck& deck;
  const std::string& group;
  const std::string& what;
  int k;
  Diagnostics& diagnostics;

  std::string name(const char* part) const { return what + part; }
  void refuse(const std::string& variable, Subscript at, const std::string& message, const std::string& hint) const {
    diagnostics.add(deck.remark(Severity::error, group, variable, at, message, hint));
  }
};

/// The times and factors as far as they ascend; what is wrong with them is told.
Amplitude table_of(const Named& of) {
  const std::string times = of.name("_time"), factors = of.name("_factor");
  const auto number = [&](const std::string& name, int i) { return of.deck.real(of.group, name, i, of.k); };
  Amplitude amplitude;
  for (int i = 1; i <= table_count; ++i) {
    const bool time = of.deck.given(of.group, times, i, of.k), factor = of.deck.given(of.group, factors, i, of.k);
    if (time != factor) {
      of.refuse(time ? times : factors, {i, of.k},
                fmt::format("{}({},{}) is not given", time ? factors : times, i, of.k),
                "each time of a table has its factor");
      return {};
    }
    if (!time) continue;
    if (!amplitude.time.empty() && !(number(times, i) > amplitude.time.back())) {
      of.refuse(times, {i, of.k},
                fmt::format("the times of a table ascend: {:.6g} is not behind {:.6g}", number(times, i),
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
  const double step = of.deck.real("in", "tstep");
  if (amplitude.time.size() < 3 || amplitude.factor.front() != amplitude.factor.back() ||
      amplitude.time.back() - amplitude.time.front() >= step)
    return;
  of.diagnostics.add(of.deck.remark(Severity::warning, of.group, of.name("_time"), {1, of.k},
                                    fmt::format("{} comes and goes within one step of {:.4g}", amplitude.of, step),
                                    "steps take their loads at their middle or end: lower tstep"));
}

}  // namespace

Amplitude amplitude_of(const Deck& deck, const std::string& group, const std::string& what, int k,
                       Diagnostics& diagnostics) {
  const Named of{deck, group, what, k, diagnostics};
  Amplitude amplitude = table_of(of);
  amplitude.of = fmt::format("{} {}", what == "fix" ? "support" : what, k);
  warn_of_short(of, amplitude);
  const std::string name = of.name("_expression");
  if (deck.given(group, name, k)) {
    if (!amplitude.time.empty())
      of.refuse(name, {k, 1}, fmt::format("{} has a table and an expression", amplitude.of),
                fmt::format("leave {0}_time and {0}_factor away, or this", what));
    amplitude.expression = expression_of(deck, group, name, k, {"t"}, diagnostics);
  } else if (amplitude.time.empty() && group == "fem" && deck.logical("fem", "static")) {
    amplitude.time = {0, deck.real("in", "tmax")}, amplitude.factor = {0, 1};
  }
  return amplitude;
}

}  // namespace tether
