// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/mesh/lattice_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/numbers.hpp"
#include "physics/box/mesh/sizes_about.hpp"

namespace tether::coupled {
namespace {

constexpr int most_levels = 12;

class Lattices {
 public:
  Lattices(const Outline& outline, const MeshSizes& sizes)
      : dim_(outline.dim),
        size_(sizes.size),
        about_(outline, sizes),
        taken_(dim_, about_.low, about_.high, sizes.size) {}

  std::vector<Vec<3>> points() {
    const std::array<int, 3> bins = taken_.count();
    levels_ = std::min(most_levels, static_cast<int>(std::ceil(std::log2(size_ / about_.least) - 0.5)));
    std::vector<std::pair<std::array<int, 3>, double>> least;  // of each bin
    taken_.each_bin_about({0, 0, 0}, std::max({bins[0], bins[1], bins[2]}),
                          [&](const std::array<int, 3>& bin) { least.emplace_back(bin, least_in(bin)); });
    for (level_ = 0; level_ <= levels_; ++level_) {
      step_ = size_ * std::pow(0.5, level_);
      for (const auto& [bin, size] : least) {
        if (level_ == 0 || size <= step_ * std::sqrt(2.0)) dim_ == 2 ? triangles_in(bin) : cubes_in(bin);
      }
    }
    return std::move(points_);
  }

 private:
  double least_in(const std::array<int, 3>& bin) const {
    const double half = 0.5 * size_;
    Vec<3> middle = about_.low, wide{};
    for (std::size_t a = 0; a < at(dim_); ++a) middle[a] += (2 * bin[a] + 1) * half, wide[a] = half;
    return about_.least_in(middle, wide);
  }

  /// Lattice points of a bin, from its lower end on.
  std::array<int, 2> range(int bin, double spacing) const {
    return {static_cast<int>(std::ceil(bin * size_ / spacing)),
            static_cast<int>(std::ceil((bin + 1) * size_ / spacing))};
  }

  void triangles_in(const std::array<int, 3>& bin) {
    const double height = about_.high[1] - about_.low[1];
    const int rows = std::max(1, static_cast<int>(std::round(height / (step_ * std::sqrt(0.75)))));
    const auto of_row = range(bin[1], height / rows), of_column = range(bin[0], step_);
    for (int j = of_row[0]; j < std::min(of_row[1], rows + 1); ++j) {
      for (int i = of_column[0]; i < of_column[1]; ++i)
        take({about_.low[0] + (i + (j % 2 == 0 ? 0 : 0.5)) * step_, about_.low[1] + height / rows * j, 0});
    }
  }

  void cubes_in(const std::array<int, 3>& bin) {
    const auto x = range(bin[0], step_), y = range(bin[1], step_), z = range(bin[2], step_);
    for (const double shift : {0.0, 0.5}) {
      for (int k = z[0]; k < z[1]; ++k) {
        for (int j = y[0]; j < y[1]; ++j) {
          for (int i = x[0]; i < x[1]; ++i)
            take({about_.low[0] + (i + shift) * step_, about_.low[1] + (j + shift) * step_,
                  about_.low[2] + (k + shift) * step_});
        }
      }
    }
  }

  void take(const Vec<3>& x) {
    for (std::size_t a = 0; a < 3; ++a) {
      if (x[a] > about_.high[a]) return;
    }
    const double size = about_.size_at(x), root = std::sqrt(2.0);
    const bool coarser = size > step_ * root && level_ > 0, finer = size <= step_ / root && level_ < levels_;
    if (size == 0 || coarser || finer) return;
    bool free = true;
    taken_.each_within(x, SizesAbout::apart * size, [&](const PlacesInBins::Place& place) {
      free = free && (place.size == step_ || distance(x, place.x) >= SizesAbout::apart * size);
    });
    if (free) taken_.add(x, step_), points_.push_back(x);
  }

  int dim_;
  double size_;
  SizesAbout about_;
  PlacesInBins taken_;
  int level_ = 0, levels_ = 0;
  double step_ = 0;
  std::vector<Vec<3>> points_;
};

}  // namespace

std::vector<Vec<3>> lattice_points(const Outline& outline, const MeshSizes& sizes) {
  return Lattices(outline, sizes).points();
}

}  // namespace tether::coupled
