// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/coupled/smoke.hpp"

#include <algorithm>
#include <cmath>

#include "solvers/coupled/smoke_passages.hpp"

namespace tether::coupled {
namespace {

constexpr double largest_share = 0.8;  // of its volume that a cell gives away in a step that is short enough
constexpr double all_but_some = 0.9;   // of its volume that a cell may give away in any
constexpr double kept = 1e-3;          // of a full cell's volume, that a cell does not give away
constexpr double starved = 0.1;        // of a full cell's volume: with less a cell has no say in the number of steps
constexpr double most_pairs = 32;      // of steps

// What goes through a passage in a step.
struct Moved {
  double volume, smoke, heat;
};

// The mean, over the share of cell `from` that leaves it, of what is linear in it with van Leer's slope.
double mean_of_leaving(const std::vector<double>& values, const SmokePassage& passage, double share) {
  const double own = values[static_cast<std::size_t>(passage.from)];
  if (passage.behind < 0 || passage.to < 0) return own;
  const double before = own - values[static_cast<std::size_t>(passage.behind)],
               after = values[static_cast<std::size_t>(passage.to)] - own, product = before * after;
  return product > 0 ? own + (1 - share) * product / (before + after) : own;
}

class SmokeCarrier {
 public:
  SmokeCarrier(const FlowDomain& domain, const FaceValues& v, const std::vector<SmokeJet>& jets, Smoke& smoke)
      : dim_(static_cast<std::size_t>(domain.grid.dim)),
        full_(domain.grid.volume()),
        smoke_(smoke),
        jets_(jets),
        passages_(smoke_passages(domain, v, jets)),
        given_(smoke.volume.size()),
        density_(smoke.volume.size()),
        temperature_(smoke.volume.size()) {}

  SmokeFlow carry(double h) {
    const double pairs = std::clamp(std::ceil(0.5 * h * fastest() / largest_share), 1.0, most_pairs);
    for (int pair = 0; pair < static_cast<int>(pairs); ++pair) {
      for (std::size_t a = 0; a < dim_; ++a) sweep(passages_[a], 0.5 * h / pairs);
      for (std::size_t a = dim_; a-- > 0;) sweep(passages_[a], 0.5 * h / pairs);
    }
    return flow_;
  }

 private:
  // The largest share of its volume that a cell gives away per time.
  double fastest() {
    std::fill(given_.begin(), given_.end(), 0.0);
    for (const auto& along : passages_) {
      for (const SmokePassage& p : along) {
        if (p.from >= 0) given_[static_cast<std::size_t>(p.from)] += p.rate;
      }
    }
    double largest = 0;
    for (std::size_t c = 0; c < given_.size(); ++c) {
      if (smoke_.volume[c] > starved * full_) largest = std::max(largest, given_[c] / smoke_.volume[c]);
    }
    return largest;
  }

  void sweep(const std::vector<SmokePassage>& passages, double h) {
    find_concentrations();
    std::fill(given_.begin(), given_.end(), 0.0);
    for (const SmokePassage& p : passages) {
      if (p.from >= 0) given_[static_cast<std::size_t>(p.from)] += h * p.rate;
    }
    moved_.resize(passages.size());
    for (std::size_t i = 0; i < passages.size(); ++i)
      moved_[i] = passages[i].from < 0 ? coming(passages[i], h) : leaving(passages[i], h);
    for (std::size_t i = 0; i < passages.size(); ++i) move(passages[i], moved_[i]);
  }

  void find_concentrations() {
    for (std::size_t c = 0; c < density_.size(); ++c) {
      const double w = smoke_.volume[c], per_volume = w > 0 ? 1 / w : 0;
      density_[c] = smoke_.smoke[c] * per_volume;
      temperature_[c] = smoke_.heat[c] * per_volume;
    }
  }

  Moved coming(const SmokePassage& p, double h) const {
    const double volume = h * p.rate;
    if (p.jet < 0) return {volume, 0, 0};
    const SmokeJet& jet = jets_[static_cast<std::size_t>(p.jet)];
    return {volume, volume * jet.density, volume * jet.temperature};
  }

  Moved leaving(const SmokePassage& p, double h) const {
    const auto c = static_cast<std::size_t>(p.from);
    const double held = smoke_.volume[c], most = std::clamp(held - kept * full_, 0.0, all_but_some * held);
    double volume = h * p.rate;
    if (given_[c] > most) volume *= most / given_[c];
    const double share = held > 0 ? volume / held : 0;
    return {volume, volume * mean_of_leaving(density_, p, share), volume * mean_of_leaving(temperature_, p, share)};
  }

  void move(const SmokePassage& p, const Moved& m) {
    if (p.from >= 0) {
      const auto c = static_cast<std::size_t>(p.from);
      smoke_.volume[c] -= m.volume, smoke_.smoke[c] -= m.smoke, smoke_.heat[c] -= m.heat;
    } else {
      flow_.smoke_in += m.smoke, flow_.heat_in += m.heat;
    }
    if (p.to >= 0) {
      const auto c = static_cast<std::size_t>(p.to);
      smoke_.volume[c] += m.volume, smoke_.smoke[c] += m.smoke, smoke_.heat[c] += m.heat;
    } else {
      flow_.smoke_out += m.smoke, flow_.heat_out += m.heat;
    }
  }

  std::size_t dim_;
  double full_;
  Smoke& smoke_;
  SmokeFlow flow_;
  const std::vector<SmokeJet>& jets_;
  std::array<std::vector<SmokePassage>, 3> passages_;
  std::vector<Moved> moved_;
  std::vector<double> given_, density_, temperature_;
};

}  // namespace

Smoke clean_smoke(const FlowDomain& domain) {
  const std::size_t count = domain.grid.cell_count();
  Smoke smoke{std::vector<double>(count), std::vector<double>(count), std::vector<double>(count)};
  for (std::size_t c = 0; c < count; ++c)
    smoke.volume[c] = domain.kind[c] == CellKind::fluid ? domain.grid.volume() : 0;
  return smoke;
}

SmokeFlow carry_smoke(const FlowDomain& domain, const FaceValues& v, double h, const std::vector<SmokeJet>& jets,
                      Smoke& smoke) {
  return SmokeCarrier(domain, v, jets, smoke).carry(h);
}

void add_buoyancy(const FlowDomain& domain, const Smoke& smoke, double lift, double weight, double h, FaceValues& v) {
  for (std::size_t f = 0; f < v[1].size(); ++f) {
    if (domain.face[1][f] != FaceKind::open) continue;
    double sum = 0;
    int count = 0;
    for (const int side : cells_beside(domain.grid, 1, f)) {
      const auto c = static_cast<std::size_t>(side);
      if (side < 0 || domain.kind[c] != CellKind::fluid) continue;
      sum += lift * smoke.temperature(c) - weight * smoke.density(c);
      ++count;
    }
    if (count > 0) v[1][f] += h * sum / count;
  }
}

}  // namespace tether::coupled
