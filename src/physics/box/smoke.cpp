// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/smoke.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/blocks.hpp"

namespace tether::coupled {
namespace {

class Finder {
 public:
  Finder(const FlowDomain& domain, int axis, const std::vector<SmokeJet>& jets)
      : domain_(domain), axis_(axis), a_(static_cast<std::size_t>(axis)) {
    for (std::size_t i = 0; i < jets.size(); ++i) {
      if (jets[i].axis == axis) jets_.push_back({jets[i].face, static_cast<int>(i)});
    }
    std::sort(jets_.begin(), jets_.end());
    const std::size_t count = domain.grid.cell_count();
    found_.stride = static_cast<std::ptrdiff_t>(domain.grid.cell(axis == 0, axis == 1, axis == 2));
    found_.up.assign(count, 0.0), found_.down.assign(count, 0.0), found_.has_slope.assign(count, 0.0);
  }

  SmokePassages find(const std::vector<double>& v) {
    std::size_t c = 0;
    const auto& n = domain_.grid.n;
    for (int k = 0; k < n[2]; ++k) {
      for (int j = 0; j < n[1]; ++j) {
        for (int i = 0; i < n[0]; ++i, ++c) {
          if (domain_.kind[c] == CellKind::fluid) look_at({i, j, k}, c, v);
        }
      }
    }
    return std::move(found_);
  }

 private:
  void look_at(const std::array<int, 3>& cell, std::size_t c, const std::vector<double>& v) {
    bool fluid_beside = true;
    for (const bool upper : {false, true}) {
      auto face = cell;
      face[a_] += upper ? 1 : 0;
      const std::size_t f = domain_.grid.face(axis_, face);
      const bool shut = domain_.face[a_][f] == FaceKind::closed, outer = !has_fluid_beyond(cell[a_], c, upper);
      fluid_beside = fluid_beside && !shut && !outer;
      if (shut) continue;
      const double rate = domain_.area[a_][f] * (upper ? v[f] : -v[f]);
      if (rate > 0) (upper ? found_.up : found_.down)[c] = rate;
      if (outer && rate > 0) found_.out.push_back({c, upper, -1, rate});
      if (outer && rate < 0) found_.in.push_back({c, upper, jet_at(f), -rate});
    }
    found_.has_slope[c] = fluid_beside ? 1 : 0;
  }

  bool has_fluid_beyond(int place, std::size_t c, bool upper) const {
    if (place == (upper ? domain_.grid.n[a_] - 1 : 0)) return false;
    const auto stride = static_cast<std::size_t>(found_.stride);
    return domain_.kind[upper ? c + stride : c - stride] == CellKind::fluid;
  }

  int jet_at(std::size_t f) const {
    const auto jet = std::lower_bound(jets_.begin(), jets_.end(), std::pair{f, 0});
    return jet != jets_.end() && jet->first == f ? jet->second : -1;
  }

  const FlowDomain& domain_;
  int axis_;
  std::size_t a_;
  std::vector<std::pair<std::size_t, int>> jets_;  // by face
  SmokePassages found_;
};

}  // namespace

SmokePassages smoke_passages(const FlowDomain& domain, int axis, const std::vector<double>& v,
                             const std::vector<SmokeJet>& jets) {
  return Finder(domain, axis, jets).find(v);
}

namespace {

constexpr double largest_share = 0.8;  // of its volume that a cell gives away in a step that is short enough
constexpr double all_but_some = 0.9;   // of its volume that a cell may give away in any
constexpr double kept = 1e-3;          // of a full cell's volume, that a cell does not give away
constexpr double starved = 0.1;        // of a full cell's volume: with less a cell has no say in the number of steps
constexpr double most_pairs = 32;      // of steps

constexpr double tiny = std::numeric_limits<double>::min();  // keeps 0 / 0 away and changes nothing else

/// Numbers of cells; those beyond the first and the last cell are zero.
class CellNumbers {
 public:
  CellNumbers(std::size_t cells, std::size_t beyond) : beyond_(beyond), values_(cells + 2 * beyond) {}
  double* data() { return values_.data() + beyond_; }
  const double* data() const { return values_.data() + beyond_; }

 private:
  std::size_t beyond_;
  std::vector<double> values_;
};

/// What leaves each cell through one of its sides in a step.
struct Leaving {
  CellNumbers volume, smoke, heat;
  Leaving(std::size_t cells, std::size_t beyond) : volume(cells, beyond), smoke(cells, beyond), heat(cells, beyond) {}
};

/// Half of van Leer's slope: what is linear in the cell rises by it from the middle to the upper side.
inline double half_slope(double below, double own, double above) {
  const double before = own - below, after = above - own, b = std::abs(before), a = std::abs(after);
  return 0.5 * (before * a + b * after) / (b + a + tiny);  // 0 where the signs differ
}

class SmokeCarrier {
 public:
  SmokeCarrier(Team& team, const FlowDomain& domain, const FaceValues& v, const std::vector<SmokeJet>& jets,
               Smoke& smoke)
      : team_(team),
        full_(domain.grid.volume()),
        count_(smoke.volume.size()),
        smoke_(smoke),
        jets_(jets),
        beyond_(domain.grid.cell(0, domain.grid.dim == 2, domain.grid.dim == 3)),
        density_(count_, beyond_),
        temperature_(count_, beyond_),
        up_(count_, beyond_),
        down_(count_, beyond_) {
    passages_.resize(static_cast<std::size_t>(domain.grid.dim));
    team.each(0, passages_.size(),
              [&](std::size_t a) { passages_[a] = smoke_passages(domain, static_cast<int>(a), v[a], jets); });
  }

  SmokeFlow carry(double h) {
    const double pairs = std::clamp(std::ceil(0.5 * h * fastest() / largest_share), 1.0, most_pairs);
    for (int pair = 0; pair < static_cast<int>(pairs); ++pair) {
      for (const SmokePassages& along : passages_) sweep(along, 0.5 * h / pairs);
      for (std::size_t a = passages_.size(); a-- > 0;) sweep(passages_[a], 0.5 * h / pairs);
    }
    return flow_;
  }

 private:
  // The largest share of its volume that a cell gives away along an axis per time.
  double fastest() const {
    double largest = 0;
    for (const SmokePassages& along : passages_) {
      for (std::size_t c = 0; c < count_; ++c) {
        if (smoke_.volume[c] > starved * full_)
          largest = std::max(largest, (along.up[c] + along.down[c]) / smoke_.volume[c]);
      }
    }
    return largest;
  }

  void sweep(const SmokePassages& along, double h) {
    each_block(team_, count_, [&](std::size_t begin, std::size_t end) { find_concentrations(begin, end); });
    each_block(team_, count_, [&](std::size_t begin, std::size_t end) { leave(along, h, begin, end); });
    for (const SmokePassages::Outer& face : along.out) go_out(face);
    each_block(team_, count_, [&](std::size_t begin, std::size_t end) { arrive(along.stride, begin, end); });
    for (const SmokePassages::Outer& face : along.in) come_in(face, h);
  }

  void find_concentrations(std::size_t begin, std::size_t end) {
    const double *volume = smoke_.volume.data(), *smoke = smoke_.smoke.data(), *heat = smoke_.heat.data();
    double *density = density_.data(), *temperature = temperature_.data();
#pragma GCC ivdep
    for (std::size_t c = begin; c < end; ++c) {
      const double per_volume = 1 / (volume[c] + tiny);
      density[c] = smoke[c] * per_volume;
      temperature[c] = heat[c] * per_volume;
    }
  }

  // Of what is linear in a cell the mean over the share that leaves it.
  void leave(const SmokePassages& along, double h, std::size_t begin, std::size_t end) {
    const double *rate_up = along.up.data(), *rate_down = along.down.data(), *has_slope = along.has_slope.data();
    const double *density = density_.data(), *temperature = temperature_.data(), *volume = smoke_.volume.data();
    double *volume_up = up_.volume.data(), *smoke_up = up_.smoke.data(), *heat_up = up_.heat.data();
    double *volume_down = down_.volume.data(), *smoke_down = down_.smoke.data(), *heat_down = down_.heat.data();
    const std::ptrdiff_t s = along.stride, last = static_cast<std::ptrdiff_t>(end);
    const double full = full_;
#pragma GCC ivdep
    for (auto c = static_cast<std::ptrdiff_t>(begin); c < last; ++c) {
      const double held = volume[c], most = std::min(std::max(held - kept * full, 0.0), all_but_some * held);
      const double given = h * (rate_up[c] + rate_down[c]), part = std::min(1.0, most / (given + tiny));
      const double up = h * rate_up[c] * part, down = h * rate_down[c] * part, per_volume = 1 / (held + tiny);
      const double smoke = has_slope[c] * half_slope(density[c - s], density[c], density[c + s]);
      const double heat = has_slope[c] * half_slope(temperature[c - s], temperature[c], temperature[c + s]);
      const double still_up = 1 - up * per_volume, still_down = 1 - down * per_volume;
      volume_up[c] = up, volume_down[c] = down;
      smoke_up[c] = up * (density[c] + still_up * smoke), smoke_down[c] = down * (density[c] - still_down * smoke);
      heat_up[c] = up * (temperature[c] + still_up * heat), heat_down[c] = down * (temperature[c] - still_down * heat);
    }
  }

  void go_out(const SmokePassages::Outer& face) {
    Leaving& from = face.upper ? up_ : down_;
    double &volume = from.volume.data()[face.cell], &smoke = from.smoke.data()[face.cell],
           &heat = from.heat.data()[face.cell];
    smoke_.volume[face.cell] -= volume, smoke_.smoke[face.cell] -= smoke, smoke_.heat[face.cell] -= heat;
    flow_.smoke_out += smoke, flow_.heat_out += heat;
    volume = smoke = heat = 0;
  }

  void arrive(std::ptrdiff_t stride, std::size_t begin, std::size_t end) {
    const auto first = static_cast<std::ptrdiff_t>(begin), last = static_cast<std::ptrdiff_t>(end);
    add_arriving(up_.volume.data(), down_.volume.data(), stride, first, last, smoke_.volume.data());
    add_arriving(up_.smoke.data(), down_.smoke.data(), stride, first, last, smoke_.smoke.data());
    add_arriving(up_.heat.data(), down_.heat.data(), stride, first, last, smoke_.heat.data());
  }

  static void add_arriving(const double* up, const double* down, std::ptrdiff_t s, std::ptrdiff_t first,
                           std::ptrdiff_t last, double* held) {
#pragma GCC ivdep
    for (std::ptrdiff_t c = first; c < last; ++c) held[c] += (up[c - s] - down[c]) - (up[c] - down[c + s]);
  }

  void come_in(const SmokePassages::Outer& face, double h) {
    const double volume = h * face.rate;
    smoke_.volume[face.cell] += volume;
    if (face.jet < 0) return;
    const SmokeJet& jet = jets_[static_cast<std::size_t>(face.jet)];
    smoke_.smoke[face.cell] += volume * jet.density, smoke_.heat[face.cell] += volume * jet.temperature;
    flow_.smoke_in += volume * jet.density, flow_.heat_in += volume * jet.temperature;
  }

  Team& team_;
  double full_;
  std::size_t count_;
  Smoke& smoke_;
  SmokeFlow flow_;
  const std::vector<SmokeJet>& jets_;
  std::vector<SmokePassages> passages_;  // across each axis
  std::size_t beyond_;                   // the farthest that a cell's next one is
  CellNumbers density_, temperature_;
  Leaving up_, down_;
};

}  // namespace

Smoke clean_smoke(const FlowDomain& domain) {
  const std::size_t count = domain.grid.cell_count();
  Smoke smoke{std::vector<double>(count), std::vector<double>(count), std::vector<double>(count)};
  for (std::size_t c = 0; c < count; ++c)
    smoke.volume[c] = domain.kind[c] == CellKind::fluid ? domain.grid.volume() : 0;
  return smoke;
}

SmokeFlow carry_smoke(Team& team, const FlowDomain& domain, const FaceValues& v, double h,
                      const std::vector<SmokeJet>& jets, Smoke& smoke) {
  return SmokeCarrier(team, domain, v, jets, smoke).carry(h);
}

namespace {

/// Calls f(face, acceleration) for the open faces across y that fluid is next to.
template <class Function>
void each_buoyant_face(const FlowDomain& domain, const Smoke& smoke, double lift, double weight, const Function& f) {
  for (std::size_t face = 0; face < domain.face[1].size(); ++face) {
    if (domain.face[1][face] != FaceKind::open) continue;
    double sum = 0;
    int count = 0;
    for (const int side : cells_beside(domain.grid, 1, face)) {
      const auto c = static_cast<std::size_t>(side);
      if (side < 0 || domain.kind[c] != CellKind::fluid) continue;
      sum += lift * smoke.temperature(c) - weight * smoke.density(c);
      ++count;
    }
    if (count > 0) f(face, sum / count);
  }
}

}  // namespace

void add_buoyancy(const FlowDomain& domain, const Smoke& smoke, double lift, double weight, double h, FaceValues& v) {
  each_buoyant_face(domain, smoke, lift, weight, [&](std::size_t face, double up) { v[1][face] += h * up; });
}

double buoyancy_power(const FlowDomain& domain, const Smoke& smoke, double lift, double weight, double density,
                      const FaceValues& v) {
  double power = 0;
  each_buoyant_face(domain, smoke, lift, weight,
                    [&](std::size_t face, double up) { power += density * domain.volume[1][face] * up * v[1][face]; });
  return power;
}

}  // namespace tether::coupled
