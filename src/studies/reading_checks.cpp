// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/reading_checks.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cctype>

#include "read/reference/reference.hpp"
#include "results/summary_keys.hpp"
#include "run/make.hpp"
#include "studies/history_value.hpp"

namespace tether {
namespace {

using Names = std::vector<std::string>;

bool contains(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

void add(Names& names, const Names& more) {
  for (const auto& name : more) {
    if (!contains(names, name)) names.push_back(name);
  }
}

unsigned kinds_of(Path path) {
  using namespace runs_of;
  if (path == Path::mpm) return points;
  return path == Path::fem ? bars | meshes : boxes | meshes;
}

/// Returns where a name stands in a text by itself, from 1.
int column_of(const std::string& text, const std::string& name) {
  const auto is_of_name = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  for (auto at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
    const bool begins = at == 0 || !is_of_name(text[at - 1]);
    const auto end = at + name.size();
    if (begins && (end == text.size() || !is_of_name(text[end]))) return static_cast<int>(at) + 1;
  }
  return 1;
}

}  // namespace

Written written_by(const Loaded& loaded) {
  Written written{summary_keys(kinds_of(loaded.plan.scene.path())),
                  make_solver(loaded.plan)->history_layout().column_names()};
  add(written.keys, figure_keys(reference_kind(loaded.deck.text("reference.solution"))));
  return written;
}

Ending try_scene(const std::string& name, const Deck& deck, Written* written) {
  return end_of(name, [&] {
    Diagnostics of_the_run;
    const Loaded loaded = load_scene(deck, {}, of_the_run);
    if (written == nullptr) return;
    const Written by_the_run = written_by(loaded);
    add(written->columns, by_the_run.columns);
    add(written->keys, by_the_run.keys);
  });
}

published::Readout checked_reading(const Deck& deck, TextVariable name, const Written& written, StudyRemarks& remarks) {
  if (!deck.given(name)) return {};  // check_mode reports where it is missing
  const std::string text = deck.text(name);
  published::ReadReading read = published::read_reading(text);
  for (const auto& key : read.keys) {
    if (!contains(written.keys, key))
      read.mistakes.push_back(
          {column_of(text, key), fmt::format("no run writes {} into its summary", key), meant(key, written.keys)});
  }
  for (const auto& column : read.columns) {
    if (!contains(written.columns, column))
      read.mistakes.push_back({column_of(text, column), fmt::format("no run's history.txt has a column '{}'", column),
                               meant(column, written.columns)});
  }
  remarks.tell(name, 1, read.mistakes);
  return read.reading;
}

}  // namespace tether
