// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/reproduce/problems.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <tuple>

#include "base/diagnostics.hpp"
#include "base/file.hpp"
#include "base/numbers.hpp"
#include "base/text.hpp"
#include "deck/reader.hpp"
#include "studies/reproduce/problem_of_deck.hpp"

namespace tether::published {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

/// A deck with published numbers, and what was wrong with it.
struct Candidate {
  Deck deck;
  std::string name;
};

std::vector<fs::path> files_of(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::path& part : {folder, folder / "published"}) {
    if (!fs::is_directory(part)) continue;
    for (const auto& entry : fs::directory_iterator(part)) {
      if (entry.path().extension() == ".in") files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

Deck deck_in(const fs::path& file) {
  Diagnostics of_its_own;  // reported where the problem is read, and where its deck is run
  return read_deck(read_file(file), file.string(), {}, of_its_own);
}

std::vector<Candidate> candidates_in(const fs::path& folder) {
  std::vector<Candidate> candidates;
  for (const fs::path& file : files_of(folder)) {
    if (lower(read_file(file)).find(fmt::format("${}", published_group)) == std::string::npos) continue;
    Deck deck = deck_in(file);
    if (!deck.has_group(published_group)) continue;
    candidates.push_back({deck, problem_name(deck)});
  }
  return candidates;
}

bool is_path(const std::string& name) { return name.ends_with(".in"); }

void refuse_unknown(const Names& names, const std::vector<Candidate>& candidates) {
  Names known, unknown;
  for (const Candidate& candidate : candidates) known.push_back(candidate.name);
  for (const auto& name : names) {
    if (is_path(name) || std::find(known.begin(), known.end(), name) != known.end()) continue;
    const std::string near = nearest_name(name, known);
    unknown.push_back(fmt::format("'{}'{}", name, near.empty() ? "" : fmt::format(" (did you mean {}?)", near)));
  }
  if (unknown.empty()) return;
  std::sort(known.begin(), known.end());
  throw InputError(fmt::format("there is no published problem {}", fmt::join(unknown, ", ")),
                   fmt::format("The problems are {}.", fmt::join(known, ", ")));
}

/// A section's number, "A.1.5" of "A.1.5, Fig. 93": its parts, an appendix after the numbers.
std::vector<std::pair<long long, std::string>> section_of(const std::string& place) {
  std::vector<std::pair<long long, std::string>> parts;
  std::string section = place.substr(0, place.find_first_of(", "));
  for (std::size_t at = 0; at <= section.size();) {
    const std::size_t end = std::min(section.find('.', at), section.size());
    const std::string part = section.substr(at, end - at);
    parts.emplace_back(parse_integer(part).value_or(1000), part);
    at = end + 1;
  }
  return parts;
}

/// The sources that this project reproduces come first.
std::size_t rank_of(const std::string& source) {
  constexpr std::array sources{"thesis", "coupling paper", "continuum paper"};
  return static_cast<std::size_t>(std::find(sources.begin(), sources.end(), source) - sources.begin());
}

bool comes_before(const Problem& a, const Problem& b) {
  const auto key = [](const Problem& problem) {
    return std::tuple(rank_of(problem.source), problem.source, section_of(problem.place), problem.name);
  };
  return key(a) < key(b);
}

Deck user_deck(const std::string& path, Diagnostics& diagnostics) {
  Deck deck = deck_in(path);
  if (!deck.has_group(published_group))
    diagnostics.error({path, 0, 0}, "", fmt::format("there is no group ${}", published_group),
                      "it says what a run is to be compared with: see 'tether vars published'");
  return deck;
}

}  // namespace

std::vector<Problem> problems_named(const Names& names, const fs::path& decks) {
  const bool needs_folder = names.empty() || !std::all_of(names.begin(), names.end(), is_path);
  if (needs_folder && !fs::is_directory(decks))
    throw InputError(fmt::format("there is no folder {} with the decks", decks.string()),
                     "stand where decks/ is, or name the folder with --decks DIR");
  const auto candidates = needs_folder ? candidates_in(decks) : std::vector<Candidate>{};
  refuse_unknown(names, candidates);
  Diagnostics diagnostics;
  std::vector<Problem> problems;
  for (const Candidate& candidate : candidates) {
    if (names.empty() || std::find(names.begin(), names.end(), candidate.name) != names.end())
      problems.push_back(problem_of(candidate.deck, diagnostics));
  }
  for (const std::string& name : names) {
    if (is_path(name)) problems.push_back(problem_of(user_deck(name, diagnostics), diagnostics));
  }
  diagnostics.throw_if_errors();
  std::sort(problems.begin(), problems.end(), comes_before);
  return problems;
}

}  // namespace tether::published
