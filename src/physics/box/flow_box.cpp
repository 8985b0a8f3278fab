// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/flow_box.hpp"

#include <algorithm>

#include "base/numbers.hpp"
#include "base/vec.hpp"

namespace tether::coupled {
namespace {

/// Calls f(other cell, axis, face) for the neighbours of a cell.
template <class Function>
void for_neighbours(const StaggeredGrid& grid, std::size_t cell, const Function& f) {
  const auto place = grid.place_of_cell(cell);
  for (int axis = 0; axis < grid.dim; ++axis) {
    for (const int end : {0, 1}) {
      auto face = place, other = place;
      face[at(axis)] += end, other[at(axis)] += end == 0 ? -1 : 1;
      if (grid.has_cell(other)) f(grid.cell(other), axis, grid.face(axis, face));
    }
  }
}

}  // namespace

FlowBox::FlowBox(const Coupled& scene)
    : scene_(scene),
      kind_(scene.grid.cell_count(), CellKind::fluid),
      side_faces_(std::make_shared<const SideFaces>(scene)) {
  for (std::size_t cell = 0; cell < kind_.size(); ++cell) {
    const Vec<3> middle = scene.grid.middle(scene.grid.place_of_cell(cell));
    for (const Box<3>& box : scene.voids) {
      if (box.contains(middle)) kind_[cell] = CellKind::empty;
    }
    for (const Box<3>& box : scene.obstacles) {
      if (box.contains(middle)) kind_[cell] = CellKind::wall;
    }
  }
}

FaceKind FlowBox::kind_at_side(int axis, std::size_t face, CellKind cell) const {
  if (cell != CellKind::fluid) return FaceKind::closed;
  return side_faces_->open(axis, face) > 0 ? FaceKind::open : FaceKind::prescribed;
}

double FlowBox::open_part(int axis, std::size_t face, FaceKind kind) const {
  const double part = kind == FaceKind::open ? side_faces_->open(axis, face) : 1;
  return part > 0 ? part : 1;
}

FaceKind FlowBox::kind_between(const FlowDomain& domain, int axis, std::size_t face) const {
  const auto [low, high] = cells_beside(scene_.grid, axis, face);
  if (low < 0 || high < 0) return kind_at_side(axis, face, domain.kind[at(low < 0 ? high : low)]);
  const CellKind a = domain.kind[at(low)], b = domain.kind[at(high)];
  const auto with_fluid = [&](CellKind other) {
    return (a == CellKind::fluid && b == other) || (b == CellKind::fluid && a == other);
  };
  if (with_fluid(CellKind::fluid) || with_fluid(CellKind::empty)) return FaceKind::open;
  return with_fluid(CellKind::wall) ? FaceKind::prescribed : FaceKind::closed;
}

void FlowBox::open_faces(const Crossings& crossings, FlowDomain& domain) const {
  const StaggeredGrid& grid = scene_.grid;
  for (int axis = 0; axis < grid.dim; ++axis) {
    domain.face[at(axis)].assign(grid.face_count(axis), FaceKind::closed);
    for (std::size_t f = 0; f < grid.face_count(axis); ++f) {
      if (crossings.lowest[at(axis)][f] >= 0) continue;
      const FaceKind kind = kind_between(domain, axis, f);
      domain.face[at(axis)][f] = kind;
      if (kind == FaceKind::closed) continue;
      const double open = open_part(axis, f, kind);
      domain.area[at(axis)][f] = grid.area(axis) * open;
      const auto place = grid.place_of_face(axis, f);
      const bool at_side = place[at(axis)] == 0 || place[at(axis)] == grid.n[at(axis)];
      domain.volume[at(axis)][f] =
          grid.volume() * (at_side ? 0.5 * open : 1);  // to the side, where the pressure is zero
    }
  }
}

FlowDomain FlowBox::without_regions(const Crossings& crossings) const {
  FlowDomain domain{scene_.grid, kind_, {}, face_values(scene_.grid), face_values(scene_.grid), {}, 0, {}, side_faces_};
  for (std::size_t side = 0; side < domain.slips.size(); ++side)
    domain.slips[side] = scene_.sides[side] == BoxSide::slip;
  for (std::size_t cell = 0; cell < kind_.size(); ++cell) {
    if (kind_[cell] == CellKind::wall) continue;
    if (crossings.inside[cell] != 0)
      domain.kind[cell] = CellKind::solid;
    else if (scene_.cavities_only && crossings.in_cavity[cell] == 0)
      domain.kind[cell] = CellKind::empty;
  }
  open_faces(crossings, domain);
  return domain;
}

FlowDomain FlowBox::around(const Crossings& crossings) const {
  FlowDomain domain = without_regions(crossings);
  find_regions(domain);
  return domain;
}

/// Cells whose middle is in a solid take the kind of the cells that their open faces lead to. Where these are of
/// different kinds, a solid divides fluid and void here, and the cell stays closed.
void FlowBox::fill_cut_cells(const CutCells& cut, FlowDomain& domain) const {
  bool more = true;
  while (more) {
    more = false;
    const std::vector<CellKind> before = domain.kind;
    for (std::size_t cell = 0; cell < before.size(); ++cell) {
      if (before[cell] != CellKind::solid || cut.thin[cell] != 0) continue;
      bool to_fluid = false, to_void = false;
      for_neighbours(scene_.grid, cell, [&](std::size_t other, int axis, std::size_t face) {
        if (cut.fluid[at(axis)][face] == 0 || cut.thin[other] != 0) return;
        to_fluid = to_fluid || before[other] == CellKind::fluid;
        to_void = to_void || before[other] == CellKind::empty;
      });
      if (to_fluid == to_void) continue;
      domain.kind[cell] = to_fluid ? CellKind::fluid : CellKind::empty;
      more = true;
    }
  }
}

void FlowBox::open_cut_cells(const Crossings& crossings, const CutCells& cut, FlowDomain& domain) const {
  const StaggeredGrid& grid = scene_.grid;
  fill_cut_cells(cut, domain);
  const auto held = [&](int cell) { return crossings.inside[at(cell)] != 0; };
  for (int axis = 0; axis < grid.dim; ++axis) {
    for (std::size_t f = 0; f < grid.face_count(axis); ++f) {
      const auto [low, high] = cells_beside(grid, axis, f);
      if ((low >= 0 && cut.thin[at(low)] != 0) || (high >= 0 && cut.thin[at(high)] != 0)) continue;
      const double fluid = cut.fluid[at(axis)][f], whole = grid.volume() * (low < 0 || high < 0 ? 0.5 : 1);
      const bool divided = low >= 0 && high >= 0 && domain.kind[at(low)] != domain.kind[at(high)] &&
                           (held(low) || held(high));  // void on one side of a solid, fluid on the other
      const FaceKind kind = fluid > 0 && !divided ? kind_between(domain, axis, f) : FaceKind::closed;
      domain.face[at(axis)][f] = kind;
      const double open = kind == FaceKind::closed ? 0 : open_part(axis, f, kind);
      domain.area[at(axis)][f] = grid.area(axis) * open * (fluid / whole);
      domain.volume[at(axis)][f] = open * fluid;
    }
  }
}

FlowDomain FlowBox::around(const Crossings& crossings, const CutCells& cut) const {
  FlowDomain domain = without_regions(crossings);
  open_cut_cells(crossings, cut, domain);
  find_regions(domain);
  return domain;
}

/// Returns the jets' mean speeds in a step of length h, by three points of Gauss: exact to t^5, and for a jet that is
/// switched on within the step about its part.
bool lies_in(const Box<3>& patch, int side, const Vec<3>& x, int dim) {
  bool inside = true;
  for (std::size_t a = 0; a < at(dim); ++a) {
    if (static_cast<int>(a) != axis_of_side(side)) inside = inside && x[a] > patch.low[a] && x[a] < patch.high[a];
  }
  return inside;
}

int jet_at(const Coupled& scene, int side, const Vec<3>& x) {
  for (std::size_t k = scene.jets.size(); k-- > 0;) {
    if (scene.jets[k].side == side && lies_in(scene.jets[k].patch, side, x, scene.grid.dim)) return static_cast<int>(k);
  }
  return -1;
}

std::vector<double> jet_speeds(const Coupled& scene, double time, double h) {
  constexpr double away = 0.38729833462074168852;  // sqrt(3/5)/2, of the step from its middle
  std::vector<double> speeds;
  for (const Jet& jet : scene.jets) {
    const auto at = [&](double part) { return jet.amplitude.at(time + part * h); };
    const double mean = h == 0 ? at(0) : (5 * (at(0.5 - away) + at(0.5 + away)) + 8 * at(0.5)) / 18;
    speeds.push_back(jet.speed * mean);
  }
  return speeds;
}

/// A face that a jet has but a part of takes that part of its speed: the flux is the jet's. A liquid's particles are
/// only in the jet's part, and go as fast as it.
void FlowBox::prescribe(const FlowDomain& domain, double time, double h, FaceValues& v) const {
  const std::vector<double> speeds = jet_speeds(scene_, time, h);
  for (int axis = 0; axis < scene_.grid.dim; ++axis) {
    for (std::size_t f = 0; f < domain.face[at(axis)].size(); ++f) {
      if (domain.face[at(axis)][f] != FaceKind::prescribed) continue;
      double speed = 0, parts = 0;
      for (const JetShare& share : side_faces_->jets(axis, f)) {
        speed += (is_low_side(scene_.jets[at(share.jet)].side) ? 1 : -1) * share.part * speeds[at(share.jet)];
        parts += share.part;
      }
      v[at(axis)][f] = scene_.liquid && parts > 0 ? speed / parts : speed;
    }
  }
}

/// Lists the smoke of jets. Of several jets in a face those that blow in count, each by its part of the face's flux, so
/// that what they bring is theirs, whatever others take out there.
std::vector<SmokeJet> FlowBox::smoke_of_jets(double time, double h) const {
  const std::vector<double> speeds = jet_speeds(scene_, time, h);
  std::vector<SmokeJet> jets;
  for (int axis = 0; axis < scene_.grid.dim; ++axis) {
    for (std::size_t f = 0; f < scene_.grid.face_count(axis); ++f) {
      SmokeJet smoke{axis, f, 0, 0};
      double net = 0;
      for (const JetShare& share : side_faces_->jets(axis, f)) {
        const Jet& jet = scene_.jets[at(share.jet)];
        const double flux = share.part * speeds[at(share.jet)];
        net += flux;
        smoke.density += std::max(flux, 0.0) * jet.smoke, smoke.temperature += std::max(flux, 0.0) * jet.temperature;
      }
      if (net > 0) jets.push_back({axis, f, smoke.density / net, smoke.temperature / net});
    }
  }
  return jets;
}

/// Each cell has the number of another one that it is joined with, before it, or its own if it is the first one.
void find_regions(FlowDomain& domain) {
  const StaggeredGrid& grid = domain.grid;
  std::vector<int>& first = domain.region;
  first.assign(domain.kind.size(), -1);
  const auto first_of = [&](int cell) {
    while (first[at(cell)] != cell) cell = first[at(cell)] = first[at(first[at(cell)])];
    return cell;
  };
  for (std::size_t cell = 0; cell < first.size(); ++cell)
    first[cell] = domain.kind[cell] == CellKind::fluid ? static_cast<int>(cell) : -1;
  for (int axis = 0; axis < grid.dim; ++axis) {
    const auto& faces = domain.face[at(axis)];
    for (std::size_t f = 0; f < faces.size(); ++f) {
      if (faces[f] != FaceKind::open) continue;
      const auto [low, high] = cells_beside(grid, axis, f);
      if (low < 0 || high < 0 || first[at(low)] < 0 || first[at(high)] < 0) continue;
      const int a = first_of(low), b = first_of(high);
      first[at(std::max(a, b))] = std::min(a, b);
    }
  }
  domain.regions = 0;
  for (std::size_t cell = 0; cell < first.size(); ++cell) {  // those before it have their regions' numbers already
    if (first[cell] < 0) continue;
    first[cell] = first[cell] == static_cast<int>(cell) ? domain.regions++ : first[at(first[cell])];
  }
}

void drop_regions(std::span<const std::uint8_t> regions, FlowDomain& domain) {
  for (std::size_t cell = 0; cell < domain.kind.size(); ++cell) {
    const int region = domain.region[cell];
    if (region >= 0 && regions[at(region)] != 0) domain.kind[cell] = CellKind::solid;
  }
  for (int axis = 0; axis < domain.grid.dim; ++axis) {
    for (std::size_t f = 0; f < domain.face[at(axis)].size(); ++f) {
      const auto beside = cells_beside(domain.grid, axis, f);
      for (const int cell : beside) {
        if (cell < 0 || domain.region[at(cell)] < 0 || regions[at(domain.region[at(cell)])] == 0) continue;
        domain.face[at(axis)][f] = FaceKind::closed;
        domain.area[at(axis)][f] = domain.volume[at(axis)][f] = 0;
      }
    }
  }
  find_regions(domain);
}

}  // namespace tether::coupled
