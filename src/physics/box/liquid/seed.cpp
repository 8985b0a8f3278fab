// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/liquid/seed.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "base/numbers.hpp"

namespace tether::liquid {
namespace {

constexpr std::array samples{400, 1000};  // of a small box that is cut, in the plane and in space
constexpr int few_samples = 8;            // of any, so that what is thinner than one is seen
constexpr double least_part = 0.02;       // of a small box: less is no particle, and its neighbours have it

class Seeder {
 public:
  Seeder(const Coupled& scene, const coupled::FlowDomain& room, const NearSolids& solids)
      : scene_(scene), grid_(scene.grid), room_(room), solids_(solids), per_axis_(scene.liquid->per_axis) {}

  Particles seed(std::vector<int>* without) {
    const auto& regions = scene_.liquid->regions;
    for (std::size_t r = 0; r < regions.size(); ++r) {
      const std::size_t first = particles_.size();
      missed_ = kept_ = 0;
      each_small_box([&](const Vec<3>& low, const Vec<3>& d) { add(r, low, d); });
      for (std::size_t k = first; k < particles_.size(); ++k) particles_.volume[k] *= 1 + missed_ / kept_;
      if (particles_.size() == first && without != nullptr) without->push_back(regions[r].number);
    }
    return std::move(particles_);
  }

 private:
  template <class Function>
  void each_small_box(const Function& f) const {
    Vec<3> d{1, 1, 1}, low{};
    std::array<int, 3> n{1, 1, 1}, i{};
    for (std::size_t a = 0; a < at(grid_.dim); ++a) n[a] = grid_.n[a] * per_axis_, d[a] = grid_.d[a] / per_axis_;
    for (i[2] = 0; i[2] < n[2]; ++i[2]) {
      for (i[1] = 0; i[1] < n[1]; ++i[1]) {
        for (i[0] = 0; i[0] < n[0]; ++i[0]) {
          for (std::size_t a = 0; a < at(grid_.dim); ++a) low[a] = grid_.low[a] + i[a] * d[a];
          f(low, d);
        }
      }
    }
  }

  /// Returns whether a place belongs to a region.
  bool holds(std::size_t region, const Vec<3>& x) const {
    const auto& regions = scene_.liquid->regions;
    if (!contains(regions[region], x)) return false;
    for (std::size_t r = 0; r < region; ++r) {
      if (contains(regions[r], x)) return false;
    }
    return room_.kind[grid_.cell(cell_of(grid_, x))] != coupled::CellKind::wall && !solids_.hold(x);
  }

  /// Calls f(place) for the corners of a small box, the middles of its edges and sides, and its own.
  template <class Function>
  void each_corner(const Vec<3>& low, const Vec<3>& d, const Function& f) const {
    std::array<int, 3> i{};
    for (i[2] = 0; i[2] < (grid_.dim == 3 ? 3 : 1); ++i[2]) {
      for (i[1] = 0; i[1] < 3; ++i[1]) {
        for (i[0] = 0; i[0] < 3; ++i[0]) {
          Vec<3> x{};
          for (std::size_t a = 0; a < at(grid_.dim); ++a) x[a] = low[a] + 0.5 * i[a] * d[a];
          f(x);
        }
      }
    }
  }

  /// Calls f(place) for places all over a small box, no two of which are at one height along any axis, so that a region
  /// that ends there is measured to one in their number: multiples of powers of 1/g, g^(dim+1) = g + 1.
  template <class Function>
  void each_sample(const Vec<3>& low, const Vec<3>& d, int count, const Function& f) const {
    const double g = grid_.dim == 2 ? 1.32471795724474602596 : 1.22074408460575947536;
    for (int k = 0; k < count; ++k) {
      Vec<3> x{};
      double by = 1;
      for (std::size_t a = 0; a < at(grid_.dim); ++a) {
        by /= g;
        const double part = 0.5 + k * by;
        x[a] = low[a] + (part - std::floor(part)) * d[a];
      }
      f(x);
    }
  }

  void add(std::size_t region, const Vec<3>& low, const Vec<3>& d) {
    int in = 0, all = 0;
    Vec<3> sum{};
    const auto look = [&](const Vec<3>& x) {
      ++all;
      if (!holds(region, x)) return;
      ++in;
      for (std::size_t a = 0; a < 3; ++a) sum[a] += x[a];
    };
    constexpr double inwards = 1e-6;  // so that the corners of boxes that touch a region's edge are on their own side
    Vec<3> first = low, size = d;
    for (std::size_t a = 0; a < at(grid_.dim); ++a) first[a] += inwards * d[a], size[a] -= 2 * inwards * d[a];
    each_corner(first, size, look);
    each_sample(low, d, few_samples, look);
    if (in == 0) return;
    if (in < all) {
      in = all = 0, sum = {};
      each_sample(low, d, samples[at(grid_.dim - 2)], look);
    }
    const double part = static_cast<double>(in) / all;
    double volume = part;
    for (const double side : d) volume *= side;
    if (part < least_part) {
      missed_ += volume;
      return;
    }
    kept_ += volume;
    for (std::size_t a = 0; a < 3; ++a) sum[a] = in < all ? sum[a] / in : low[a] + 0.5 * d[a];
    if (in == all && scene_.liquid->jitter > 0) jitter(d, sum);
    particles_.add(grid_.dim, sum, scene_.liquid->regions[region].velocity, volume);
  }

  /// Moves a place within its small box; the same in every run.
  void jitter(const Vec<3>& d, Vec<3>& x) {
    for (std::size_t a = 0; a < at(grid_.dim); ++a)
      x[a] +=
          scene_.liquid->jitter * d[a] * (static_cast<double>(random_()) / static_cast<double>(random_.max()) - 0.5);
  }

  const Coupled& scene_;
  const StaggeredGrid& grid_;
  const coupled::FlowDomain& room_;
  const NearSolids& solids_;
  int per_axis_;
  std::mt19937 random_;
  Particles particles_;
  double missed_ = 0, kept_ = 0;  // volume of a region that is in no particle, or in one
};

}  // namespace

Particles seed(const Coupled& scene, const coupled::FlowDomain& room, const NearSolids& solids,
               std::vector<int>* without) {
  return Seeder(scene, room, solids).seed(without);
}

}  // namespace tether::liquid
