// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "plan/load.hpp"

namespace tether::published {

/// The files of a finished run. Each call reads what it gives, and throws FileError where the run did not write it.
class RunFiles {
 public:
  /// `reference` is the folder of the run that a problem compares this one with; empty where there is none.
  explicit RunFiles(std::filesystem::path folder, std::filesystem::path reference = {})
      : folder_(std::move(folder)), reference_(std::move(reference)) {}
  RunFiles reference() const { return RunFiles(reference_); }

  /// A number of summary.txt; not a number where the run wrote that.
  double summary(const std::string& key) const;

  /// A column of history.txt over its records: "time", "body_vx_2".
  std::vector<double> column(const std::string& name) const;
  /// A quantity of history.nc over its records, of body or tracked point k where it has several, counted from 1.
  std::vector<double> history(const std::string& quantity, std::size_t k = 1) const;

  /// Number of the snapshots in particles.nc.
  std::size_t snapshots() const;
  /// Time of one of them, counted from 0.
  double time(std::size_t snapshot) const;
  /// A field of all points, or of those of one body, counted from 1.
  std::vector<double> points(const std::string& field, std::size_t snapshot) const;
  std::vector<double> points(const std::string& field, std::size_t snapshot, int body) const;

  /// A field at the nodes of mesh.nc in one of its snapshots, of a grid row by row; "x" and "y" are the nodes' places.
  std::vector<double> nodes(const std::string& field, std::size_t snapshot) const;
  /// Number of those snapshots.
  std::size_t node_snapshots() const;

  /// The scene that ran, of deck.effective; read once. Throws FileError where it cannot be read again.
  const Scene& scene() const;
  /// A number of that deck, "reg.matr(1,2)"; not a number where the deck has none.
  double deck_value(const std::string& element) const;

  /// Returns a value of a bisection's outcome.nc: "largest_holding", which is not a number where none held.
  double outcome(const std::string& name) const;

 private:
  std::filesystem::path folder_, reference_;
  const Loaded& loaded() const;
  mutable std::shared_ptr<const Loaded> loaded_;  // read when it is first asked for
};

}  // namespace tether::published
