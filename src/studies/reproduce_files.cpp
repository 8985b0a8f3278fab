// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/reproduce_files.hpp"

#include <fmt/format.h>

#include <set>

#include "base/errors.hpp"
#include "base/numbers.hpp"
#include "plan/load.hpp"
#include "results/netcdf_input.hpp"
#include "results/summary_keys.hpp"

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

}  // namespace

double RunFiles::summary(const std::string& key) const {
  const auto path = folder_ / "summary.txt";
  for (const auto& [name, text] : read_summary(path)) {
    if (name != key) continue;
    if (const auto number = parse_real(text)) return *number;
  }
  throw FileError(fmt::format("{}: there is no number {}", path.string(), key));
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

std::vector<double> RunFiles::node_x() const {
  const NetcdfInput file(folder_ / "mesh.nc");
  const auto columns = file.numbers("node_x");
  std::vector<double> x;
  for (std::size_t row = 0; row < file.shape("node_y").front(); ++row)
    x.insert(x.end(), columns.begin(), columns.end());
  return x;
}

std::vector<double> RunFiles::node_y() const {
  const NetcdfInput file(folder_ / "mesh.nc");
  std::vector<double> y;
  for (const double row : file.numbers("node_y")) y.insert(y.end(), file.shape("node_x").front(), row);
  return y;
}

std::vector<double> RunFiles::nodes(const std::string& field, std::size_t snapshot) const {
  const NetcdfInput file(folder_ / "mesh.nc");
  const auto shape = file.shape(field);
  return file.numbers(field, {{snapshot, 0, 0}, {1, shape[1], shape[2]}});
}

std::size_t RunFiles::node_snapshots() const { return NetcdfInput(folder_ / "mesh.nc").shape("time").front(); }

const Scene& RunFiles::scene() const {
  if (scene_) return *scene_;
  const auto file = deck_of(folder_);
  try {
    scene_ = std::make_shared<const Scene>(load(file.string(), {}).plan.scene);
  } catch (const InputError& error) {
    throw FileError(fmt::format("{}: {}", file.string(), error.what()));
  }
  return *scene_;
}

double RunFiles::largest_holding() const {
  return NetcdfInput(folder_ / "outcome.nc").numbers("largest_holding").front();
}

}  // namespace tether::published
