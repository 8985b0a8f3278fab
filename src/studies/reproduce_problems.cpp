// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/reproduce_problems.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

#include "base/diagnostics.hpp"
#include "base/text.hpp"

namespace tether::published {
namespace {

std::vector<std::string> names_of(const std::vector<Problem>& problems) {
  std::vector<std::string> names;
  std::transform(problems.begin(), problems.end(), std::back_inserter(names),
                 [](const Problem& problem) { return problem.name; });
  return names;
}

void refuse_unknown(const std::vector<std::string>& names, const std::vector<std::string>& known) {
  std::vector<std::string> unknown;
  for (const auto& name : names) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    const std::string near = nearest_name(name, known);
    unknown.push_back(fmt::format("'{}'{}", name, near.empty() ? "" : fmt::format(" (did you mean {}?)", near)));
  }
  if (unknown.empty()) return;
  throw InputError(fmt::format("there is no published problem {}", fmt::join(unknown, ", ")),
                   fmt::format("The problems are {}.", fmt::join(known, ", ")));
}

}  // namespace

std::vector<Problem> all_problems() {
  std::vector<Problem> all;
  for (const auto part : {problems_of_chapter4, problems_of_chapter5, pendulums, problems_of_chapter6,
                          membrane_expansions, airbags, problems_of_chapters7and8, two_bars, balls_and_nets, noise}) {
    auto some = part();
    std::move(some.begin(), some.end(), std::back_inserter(all));
  }
  return all;
}

std::vector<Problem> problems_named(const std::vector<std::string>& names) {
  auto problems = all_problems();
  refuse_unknown(names, names_of(problems));
  if (names.empty()) return problems;
  const auto unwanted = [&](const Problem& problem) {
    return std::find(names.begin(), names.end(), problem.name) == names.end();
  };
  problems.erase(std::remove_if(problems.begin(), problems.end(), unwanted), problems.end());
  return problems;
}

}  // namespace tether::published
