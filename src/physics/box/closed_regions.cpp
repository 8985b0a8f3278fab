// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/closed_regions.hpp"

#include <algorithm>
#include <numeric>

#include "base/numbers.hpp"

namespace tether::coupled {
namespace {

/// Regions that one sheet bounds are one group, called after the lowest of them.
std::vector<int> groups_by_sheets(const CouplingMap& map, int regions, std::size_t sheets) {
  std::vector<int> group(at(regions));
  std::iota(group.begin(), group.end(), 0);
  for (std::size_t s = 0; s < sheets; ++s) {
    int first = -1;
    for (int r = 0; r < regions; ++r) {
      if (map.area_seen[s * at(regions) + at(r)] == 0) continue;
      if (first < 0) first = group[at(r)];
      const int from = std::max(first, group[at(r)]), to = std::min(first, group[at(r)]);
      std::replace(group.begin(), group.end(), from, to);
      first = to;
    }
  }
  return group;
}

}  // namespace

std::vector<std::uint8_t> closed_regions(const FlowDomain& domain) {
  std::vector<std::uint8_t> closed(at(domain.regions), 1);
  for (int axis = 0; axis < domain.grid.dim; ++axis) {
    for (std::size_t f = 0; f < domain.face[at(axis)].size(); ++f) {
      if (domain.face[at(axis)][f] != FaceKind::open) continue;
      const auto [low, high] = cells_beside(domain.grid, axis, f);
      const int a = low < 0 ? -1 : domain.region[at(low)], b = high < 0 ? -1 : domain.region[at(high)];
      if (a < 0 || b < 0) closed[at(std::max(a, b))] = 0;
    }
  }
  return closed;
}

std::vector<std::uint8_t> find_pockets(const FlowDomain& domain, const CouplingMap& map) {
  const double most = domain.grid.dim == 2 ? 9 : 27;  // cells
  std::vector<double> sizes(at(domain.regions), 0.0);
  for (const int region : domain.region) {
    if (region >= 0) ++sizes[at(region)];
  }
  return find_pockets(sizes, closed_regions(domain), map.area_seen, most);
}

std::vector<std::uint8_t> find_pockets(std::span<const double> sizes, std::span<const std::uint8_t> closed,
                                       std::span<const double> area_seen, double most) {
  std::vector<std::uint8_t> pocket(sizes.size(), 0);
  for (std::size_t first = 0; first < area_seen.size(); first += sizes.size()) {  // of each sheet
    double largest = 0;
    for (std::size_t r = 0; r < sizes.size(); ++r) {
      if (area_seen[first + r] > 0) largest = std::max(largest, sizes[r]);
    }
    for (std::size_t r = 0; r < sizes.size(); ++r) {
      if (area_seen[first + r] > 0 && closed[r] != 0 && sizes[r] <= most && sizes[r] < largest) pocket[r] = 1;
    }
  }
  return pocket;
}

FlowRegions regions_of(const FlowDomain& domain, const PressureNumbers& numbers) {
  return {of_cells(numbers, domain.region), domain.regions, closed_regions(domain)};
}

Regions regions_of(const FlowRegions& of, const CouplingMap& map, std::span<const double> volumes,
                   std::span<const double> first, std::span<const std::uint8_t> held, double h) {
  const std::size_t count = at(of.count);
  Regions regions{of.closed, std::vector<std::uint8_t>(count, 0), std::vector<double>(count, 0.0),
                  std::vector<std::size_t>(count, 0)};
  for (std::int64_t row = 0; row < map.B.outerSize(); ++row) {
    const auto region = at(of.of[static_cast<std::size_t>(row)]);
    ++regions.cells[region];
    for (CouplingMatrix::InnerIterator entry(map.B, row); entry; ++entry) {
      if (held[static_cast<std::size_t>(entry.col())] == 0) regions.compliant[region] = 1;
    }
  }
  const std::vector<int> group = groups_by_sheets(map, of.count, volumes.size());
  std::vector<double> lost(count, 0.0);
  std::vector<std::size_t> cells(count, 0);
  std::vector<std::uint8_t> closed(count, 1);
  for (std::size_t r = 0; r < count; ++r) {
    cells[at(group[r])] += regions.cells[r];
    if (regions.closed[r] == 0) closed[at(group[r])] = 0;
  }
  for (std::size_t s = 0; s < volumes.size(); ++s) {
    for (std::size_t r = 0; r < count; ++r) {
      if (map.area_seen[s * count + r] == 0) continue;
      lost[at(group[r])] += volumes[s] - first[s];
      break;  // its group has it
    }
  }
  for (std::size_t r = 0; r < count; ++r) {
    const std::size_t g = at(group[r]);
    if (closed[g] != 0) regions.source[r] = lost[g] / (h * static_cast<double>(cells[g]));
  }
  return regions;
}

std::vector<std::uint8_t> regions_of_jets(const FlowDomain& domain, const FaceValues& v) {
  std::vector<std::uint8_t> by_jets(at(domain.regions), 0);
  for (int axis = 0; axis < domain.grid.dim; ++axis) {
    for (std::size_t f = 0; f < domain.face[at(axis)].size(); ++f) {
      if (domain.face[at(axis)][f] != FaceKind::prescribed || v[at(axis)][f] == 0) continue;
      for (const int cell : cells_beside(domain.grid, axis, f)) {
        if (cell >= 0 && domain.region[at(cell)] >= 0) by_jets[at(domain.region[at(cell)])] = 1;
      }
    }
  }
  return by_jets;
}

int unmeasured_region(std::span<const std::uint8_t> by_jets, const CouplingMap& map, const Regions& regions,
                      std::span<const std::uint8_t> cavity) {
  const std::size_t count = by_jets.size();
  std::vector<std::uint8_t> shared(count, 0), in_cavity(count, 0);
  for (std::size_t s = 0; s < cavity.size(); ++s) {
    const auto sees = [&](std::size_t r) { return map.area_seen[s * count + r] > 0; };
    std::size_t seen = 0;
    for (std::size_t r = 0; r < count; ++r) seen += sees(r) ? 1U : 0U;
    for (std::size_t r = 0; r < count; ++r) {
      if (!sees(r)) continue;
      if (cavity[s] != 0) in_cavity[r] = 1;
      if (seen > 1) shared[r] = 1;
    }
  }
  for (std::size_t r = 0; r < count; ++r) {
    const bool moves = regions.closed[r] != 0 && regions.compliant[r] != 0 && by_jets[r] != 0;
    if (moves && shared[r] != 0 && in_cavity[r] == 0) return static_cast<int>(r);
  }
  return -1;
}

}  // namespace tether::coupled
