// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/reproduce/files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>

#include "base/diagnostics.hpp"
#include "base/numbers.hpp"
#include "results/netcdf_file.hpp"
#include "results/summary_keys.hpp"
#include "studies/assignment.hpp"

namespace tether::published {
namespace {

constexpr const char* effective_deck = "deck.effective";

/// The deck that ran; of a bisection's runs, which differ in one number only, the first one's.
std::filesystem::path deck_of(const std::filesystem::path& folder) {
  auto file = folder / effective_deck;
  if (std::filesystem::exists(file) || !std::filesystem::is_directory(folder / "runs")) return file;
  std::set<std::filesystem::path> decks;
  for (const auto& run : std::filesystem::directory_iterator(folder / "runs"))
    decks.insert(run.path() / effective_deck);
  return decks.empty() ? file : *decks.begin();
}

/// Places of the nodes of a grid, row by row.
std::vector<double> grid_places(const NetcdfInput& file, bool along_x) {
  const auto columns = file.numbers("node_x"), rows = file.numbers("node_y");
  std::vector<double> places;
  for (const double row : rows) {
    if (along_x)
      places.insert(places.end(), columns.begin(), columns.end());
    else
      places.insert(places.end(), columns.size(), row);
  }
  return places;
}

}  // namespace

double RunFiles::summary(const std::string& key) const {
  const auto path = folder_ / "summary.txt";
  for (const auto& [name, text] : read_summary(path)) {
    if (name != key) continue;
    if (const auto number = parse_real(text)) return *number;
  }
  throw FileError(fmt::format("{}: there is no number {}", path.string(), key));
}

std::vector<double> RunFiles::column(const std::string& name) const {
  const auto known = NetcdfInput(folder_ / "history.nc").variables();
  if (std::find(known.begin(), known.end(), name) != known.end()) return history(name);
  const auto last = name.rfind('_');
  const auto number = last == std::string::npos ? std::nullopt : parse_integer(name.substr(last + 1));
  if (number && *number > 0) return history(name.substr(0, last), static_cast<std::size_t>(*number));
  throw FileError(fmt::format("{}: there is no column {}", (folder_ / "history.nc").string(), name));
}

std::vector<double> RunFiles::history(const std::string& quantity, std::size_t k) const {
  const NetcdfInput file(folder_ / "history.nc");
  const auto shape = file.shape(quantity);
  if (shape.size() == 1) return file.numbers(quantity);
  return file.numbers(quantity, {{0, k - 1}, {shape[0], 1}});
}

std::size_t RunFiles::snapshots() const { return NetcdfInput(folder_ / "particles.nc").shape("time").front(); }

double RunFiles::time(std::size_t snapshot) const {
  return NetcdfInput(folder_ / "particles.nc").numbers("time", {{snapshot}, {1}}).front();
}

std::vector<double> RunFiles::points(const std::string& field, std::size_t snapshot) const {
  const NetcdfInput file(folder_ / "particles.nc");
  return file.numbers(field, {{snapshot, 0}, {1, file.shape(field).back()}});
}

std::vector<double> RunFiles::points(const std::string& field, std::size_t snapshot, int body) const {
  const auto all = points(field, snapshot), bodies = points("body", snapshot);
  std::vector<double> values;
  for (std::size_t p = 0; p < all.size(); ++p) {
    if (bodies[p] == body) values.push_back(all[p]);
  }
  if (values.empty()) throw FileError(fmt::format("{}: there is no body {}", folder_.string(), body));
  return values;
}

std::vector<double> RunFiles::nodes(const std::string& field, std::size_t snapshot) const {
  const NetcdfInput file(folder_ / "mesh.nc");
  const auto known = file.variables();
  const bool has_field = std::find(known.begin(), known.end(), field) != known.end();
  if (!has_field && (field == "x" || field == "y")) return grid_places(file, field == "x");
  const auto shape = file.shape(field);
  if (shape.size() == 2) return file.numbers(field, {{snapshot, 0}, {1, shape[1]}});
  return file.numbers(field, {{snapshot, 0, 0}, {1, shape[1], shape[2]}});
}

std::size_t RunFiles::node_snapshots() const { return NetcdfInput(folder_ / "mesh.nc").shape("time").front(); }

const Loaded& RunFiles::loaded() const {
  if (loaded_) return *loaded_;
  const auto file = deck_of(folder_);
  try {
    loaded_ = std::make_shared<const Loaded>(load(file.string(), {}));
  } catch (const InputError& error) {
    throw FileError(fmt::format("{}: {}", file.string(), error.what()));
  }
  return *loaded_;
}

const Scene& RunFiles::scene() const { return loaded().plan.scene; }

double RunFiles::deck_value(const std::string& element) const {
  const Assignment at = read_assignment(element + "=0", Taken::name_alone);
  if (!at.mistakes.empty()) throw FileError(fmt::format("no deck has a number {}", element));
  const Deck& deck = loaded().deck;
  const AnyVariable name(at.group, at.name);
  const Variable& variable = name.row();
  const bool has_value = deck.given(name, at.first[0], at.first[1]) || !variable.fallback.empty();
  if (!has_value) return std::numeric_limits<double>::quiet_NaN();
  if (variable.type == ValueType::integer) return deck.integer(name, at.first[0], at.first[1]);
  return variable.type == ValueType::real ? deck.real(name, at.first[0], at.first[1])
                                          : std::numeric_limits<double>::quiet_NaN();
}

double RunFiles::outcome(const std::string& name) const {
  return NetcdfInput(folder_ / "outcome.nc").numbers(name).front();
}

}  // namespace tether::published
