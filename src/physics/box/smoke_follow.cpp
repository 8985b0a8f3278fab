// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/smoke_follow.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <utility>

namespace tether::coupled {
namespace {

using Place = std::array<int, 3>;

constexpr std::size_t longest_row =
    3;  // of cells that a thin solid goes over in a step; those further are not its work

// What happens to a cell's contents when the domain changes.
enum class Part : std::uint8_t {
  none,   // it has neither contents nor fluid
  stays,  // they are its own still
  goes,   // it holds no fluid any more
  comes,  // it holds fluid and has none yet
  turns   // a thin solid has gone over it: they are on the other side
};

class Follower {
 public:
  Follower(const FlowDomain& before, const FlowDomain& now, Smoke& smoke)
      : before_(before),
        now_(now),
        grid_(now.grid),
        smoke_(smoke),
        part_(grid_.cell_count()),
        towards_(grid_.cell_count()) {
    for (std::size_t c = 0; c < part_.size(); ++c) {
      const bool fluid = now.kind[c] == CellKind::fluid, held = smoke.volume[c] > 0;
      part_[c] = fluid ? (held ? Part::stays : Part::comes) : (held ? Part::goes : Part::none);
    }
    if (before.face != now.face) {
      for (std::size_t c = 0; c < part_.size(); ++c) find_turns(c);
    }
    for (const Part part : part_) ++count_[static_cast<std::size_t>(part)];
  }

  bool changed() const { return count(Part::goes) + count(Part::comes) + count(Part::turns) > 0; }

  void give_away() {
    const Smoke held = smoke_;
    for (std::size_t c = 0; c < part_.size(); ++c) {
      if (part_[c] != Part::goes && part_[c] != Part::turns) continue;
      const std::vector<std::size_t> to = receivers(c);
      if (to.empty()) continue;
      smoke_.volume[c] = smoke_.smoke[c] = smoke_.heat[c] = 0;
      const auto parts = static_cast<double>(to.size());
      for (const std::size_t r : to) add(r, held.volume[c] / parts, held.smoke[c] / parts, held.heat[c] / parts);
    }
  }

  void take() {
    std::vector<std::size_t> takers;
    for (std::size_t c = 0; c < part_.size(); ++c) {
      if (now_.kind[c] == CellKind::fluid && smoke_.volume[c] == 0) takers.push_back(c);
    }
    while (!takers.empty() && take_layer(takers)) continue;
    for (const std::size_t c : takers) smoke_.volume[c] = grid_.volume();
  }

 private:
  struct Gift {
    std::size_t from, to;
    double donors;
    double volume = 0, smoke = 0, heat = 0;
  };

  std::size_t count(Part part) const { return count_[static_cast<std::size_t>(part)]; }

  void add(std::size_t c, double volume, double smoke, double heat) {
    smoke_.volume[c] += volume, smoke_.smoke[c] += smoke, smoke_.heat[c] += heat;
  }

  // The cell beyond side 2 axis + (0 or 1), if the face between was, or is, of a kind; else -1.
  static int beyond(const FlowDomain& domain, const Place& cell, int side, FaceKind kind) {
    const auto a = static_cast<std::size_t>(side / 2);
    Place face = cell, next = cell;
    face[a] += side % 2, next[a] += side % 2 == 1 ? 1 : -1;
    if (!domain.grid.has_cell(next) || domain.face[a][domain.grid.face(side / 2, face)] != kind) return -1;
    return static_cast<int>(domain.grid.cell(next));
  }

  bool always_fluid(int c) const {
    if (c < 0) return false;
    const auto cell = static_cast<std::size_t>(c);
    return before_.kind[cell] == CellKind::fluid && now_.kind[cell] == CellKind::fluid;
  }

  bool has_closed(const Place& cell, int side) const {
    return beyond(before_, cell, side, FaceKind::open) >= 0 && always_fluid(beyond(now_, cell, side, FaceKind::closed));
  }

  bool has_opened(const Place& cell, int side) const {
    return beyond(before_, cell, side, FaceKind::closed) >= 0 && always_fluid(beyond(now_, cell, side, FaceKind::open));
  }

  // A solid has gone over this cell, or over some in a row that ends here, if a face closed and another, or the one at
  // the row's other end, opened. Contents go towards the one that closed.
  void find_turns(std::size_t c) {
    if (!always_fluid(static_cast<int>(c))) return;
    const Place cell = grid_.place_of_cell(c);
    bool opened = false;
    for (int side = 0; side < 2 * grid_.dim; ++side) opened = opened || has_opened(cell, side);
    for (int side = 0; side < 2 * grid_.dim; ++side) {
      if (!has_closed(cell, side)) continue;
      opened ? turn(c, side) : turn_row(c, side);
    }
  }

  void turn_row(std::size_t end, int side) {
    const int back = side ^ 1;
    std::array<std::size_t, longest_row> row{end};
    for (std::size_t i = 0; i < longest_row; ++i) {
      const Place cell = grid_.place_of_cell(row[i]);
      if (has_opened(cell, back)) {
        for (std::size_t k = 0; k <= i; ++k) turn(row[k], side);
        return;
      }
      const int next = beyond(now_, cell, back, FaceKind::open);
      if (!always_fluid(next)) return;
      if (i + 1 < longest_row) row[i + 1] = static_cast<std::size_t>(next);
    }
  }

  void turn(std::size_t c, int side) {
    part_[c] = Part::turns;
    towards_[c] = static_cast<std::uint8_t>(towards_[c] | 1U << side);
  }

  std::vector<std::size_t> receivers(std::size_t c) const {
    std::vector<std::size_t> found = straight_on(c);
    if (found.empty() && part_[c] == Part::goes) found = nearest(c);
    return found;
  }

  // The nearest cells that stay, straight through cells that do not and faces that were open.
  std::vector<std::size_t> straight_on(std::size_t c) const {
    const Place start = grid_.place_of_cell(c);
    std::vector<std::size_t> found;
    int least = std::numeric_limits<int>::max();
    for (int side = 0; side < 2 * grid_.dim; ++side) {
      if (part_[c] == Part::turns && !(static_cast<unsigned>(towards_[c]) >> side & 1U)) continue;
      int far = 1, next = beyond(before_, start, side, FaceKind::open);
      while (next >= 0 && (part(next) == Part::goes || part(next) == Part::turns)) {
        next = beyond(before_, grid_.place_of_cell(static_cast<std::size_t>(next)), side, FaceKind::open);
        ++far;
      }
      if (next < 0 || part(next) != Part::stays || far > least) continue;
      if (far < least) found.clear();
      least = far;
      found.push_back(static_cast<std::size_t>(next));
    }
    return found;
  }

  Part part(int c) const { return part_[static_cast<std::size_t>(c)]; }

  // In the first ring of cells around that has any that stay, or else that hold fluid, the nearest of them.
  std::vector<std::size_t> nearest(std::size_t c) const {
    const bool any_stays = count(Part::stays) > 0;
    if (!any_stays && count(Part::comes) + count(Part::turns) == 0) return {};
    std::vector<std::size_t> found;
    for (int ring = 1; found.empty(); ++ring) {
      int least = std::numeric_limits<int>::max();
      each_in_ring(grid_.place_of_cell(c), ring, [&](std::size_t other, int distance) {
        const bool takes = any_stays ? part_[other] == Part::stays : now_.kind[other] == CellKind::fluid;
        if (!takes || distance > least) return;
        if (distance < least) found.clear();
        least = distance;
        found.push_back(other);
      });
    }
    return found;
  }

  template <class Function>
  void each_in_ring(const Place& middle, int ring, const Function& function) const {
    const int depth = grid_.dim == 3 ? ring : 0;
    for (int k = -depth; k <= depth; ++k) {
      for (int j = -ring; j <= ring; ++j) {
        const bool edge = std::abs(k) == ring || std::abs(j) == ring;
        for (int i = -ring; i <= ring; i += edge ? 1 : 2 * ring) {
          const Place other{middle[0] + i, middle[1] + j, middle[2] + k};
          if (grid_.has_cell(other)) function(grid_.cell(other), i * i + j * j + k * k);
        }
      }
    }
  }

  // Those that can take from their neighbours do; false where none can. Leaves the others in `takers`.
  bool take_layer(std::vector<std::size_t>& takers) {
    std::vector<Gift> gifts;
    std::vector<std::size_t> later;
    for (const std::size_t c : takers) {
      if (!ask_neighbours(c, gifts)) later.push_back(c);
    }
    std::vector<int> takers_of(part_.size());
    for (const Gift& g : gifts) ++takers_of[g.from];
    for (Gift& g : gifts) {
      const double share = 1 / ((takers_of[g.from] + 1) * g.donors);
      g.volume = share * smoke_.volume[g.from];
      g.smoke = share * smoke_.smoke[g.from];
      g.heat = share * smoke_.heat[g.from];
    }
    for (const Gift& g : gifts) {
      add(g.from, -g.volume, -g.smoke, -g.heat);
      add(g.to, g.volume, g.smoke, g.heat);
    }
    takers.swap(later);
    return !gifts.empty();
  }

  bool ask_neighbours(std::size_t c, std::vector<Gift>& gifts) const {
    const Place cell = grid_.place_of_cell(c);
    const std::size_t first = gifts.size();
    for (int side = 0; side < 2 * grid_.dim; ++side) {
      const int next = beyond(now_, cell, side, FaceKind::open);
      if (next < 0) continue;
      const auto from = static_cast<std::size_t>(next);
      if (now_.kind[from] == CellKind::fluid && smoke_.volume[from] > 0) gifts.push_back({from, c, 0});
    }
    const auto donors = static_cast<double>(gifts.size() - first);
    for (std::size_t g = first; g < gifts.size(); ++g) gifts[g].donors = donors;
    return donors > 0;
  }

  const FlowDomain& before_;
  const FlowDomain& now_;
  const StaggeredGrid& grid_;
  Smoke& smoke_;
  std::vector<Part> part_;
  std::vector<std::uint8_t> towards_;  // for those that turn: bits of the sides where their contents go
  std::array<std::size_t, 5> count_{};
};

}  // namespace

void follow_domain(const FlowDomain& before, const FlowDomain& now, Smoke& smoke) {
  Follower follower(before, now, smoke);
  if (!follower.changed()) return;
  follower.give_away();
  follower.take();
}

namespace {

// Gentle: a solid that crosses a cell in some steps leaves its neighbours most of what they gained or lost by it.
constexpr double gentle = 1.0 / 16;

}  // namespace

void settle_smoke(const FlowDomain& domain, const std::vector<double>& own, Smoke& smoke) {
  const Smoke held = smoke;
  for (int axis = 0; axis < domain.grid.dim; ++axis) {
    const auto& kind = domain.face[static_cast<std::size_t>(axis)];
    for (std::size_t f = 0; f < kind.size(); ++f) {
      if (kind[f] != FaceKind::open) continue;
      const auto cells = cells_beside(domain.grid, axis, f);
      if (cells[0] < 0 || cells[1] < 0) continue;
      auto from = static_cast<std::size_t>(cells[0]), to = static_cast<std::size_t>(cells[1]);
      if (domain.kind[from] != CellKind::fluid || domain.kind[to] != CellKind::fluid) continue;
      if (!(own[from] > 0 && own[to] > 0)) continue;
      if (held.volume[from] / own[from] < held.volume[to] / own[to]) std::swap(from, to);
      const double more = held.volume[from] / own[from] - held.volume[to] / own[to],
                   volume = gentle * more * std::min(own[from], own[to]);
      const double smoke_moved = volume * held.density(from), heat_moved = volume * held.temperature(from);
      smoke.volume[from] -= volume, smoke.smoke[from] -= smoke_moved, smoke.heat[from] -= heat_moved;
      smoke.volume[to] += volume, smoke.smoke[to] += smoke_moved, smoke.heat[to] += heat_moved;
    }
  }
}

}  // namespace tether::coupled
