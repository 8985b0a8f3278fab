// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/projection.hpp"

#include <algorithm>
#include <numeric>

#include "base/numbers.hpp"

namespace tether::coupled {
namespace {

/// Calls f(axis, face, lower pressure, upper pressure) for the faces of a kind that a pressure is beside; -1: none.
template <class Function>
void for_faces(const FlowDomain& domain, const PressureNumbers& numbers, FaceKind kind, const Function& f) {
  for (int axis = 0; axis < domain.grid.dim; ++axis) {
    const auto& faces = domain.face[at(axis)];
    for (std::size_t face = 0; face < faces.size(); ++face) {
      if (faces[face] != kind) continue;
      const auto [low, high] = cells_beside(domain.grid, axis, face);
      f(at(axis), face, low < 0 ? -1 : numbers.of_cell[at(low)], high < 0 ? -1 : numbers.of_cell[at(high)]);
    }
  }
}

}  // namespace

SparseMatrix pressure_matrix(const FlowDomain& domain, const PressureNumbers& numbers, double by) {
  using Entry = std::pair<std::int64_t, double>;
  constexpr std::size_t most = 7;
  std::vector<std::array<Entry, most>> column(numbers.cell.size());
  std::vector<std::size_t> size(numbers.cell.size(), 1);
  for (std::size_t p = 0; p < column.size(); ++p) column[p][0] = {static_cast<std::int64_t>(p), 0.0};
  for_faces(domain, numbers, FaceKind::open, [&](std::size_t axis, std::size_t face, int low, int high) {
    const double area = domain.area[axis][face], weight = by * area * area / domain.volume[axis][face];
    for (const auto& [p, q] : {std::pair(low, high), std::pair(high, low)}) {
      if (p < 0) continue;
      column[at(p)][0].second += weight;
      if (q >= 0) column[at(p)][size[at(p)]++] = {q, -weight};
    }
  });
  SparseMatrix L;
  const std::size_t entries = std::accumulate(size.begin(), size.end(), std::size_t{0});
  L.start.reserve(size.size() + 1), L.row.reserve(entries), L.value.reserve(entries);
  L.n = static_cast<std::int64_t>(column.size());
  L.start.push_back(0);
  for (std::size_t p = 0; p < column.size(); ++p) {
    std::sort(column[p].begin(), column[p].begin() + static_cast<std::ptrdiff_t>(size[p]));
    for (std::size_t k = 0; k < size[p]; ++k)
      L.row.push_back(column[p][k].first), L.value.push_back(column[p][k].second);
    L.start.push_back(static_cast<std::int64_t>(L.row.size()));
  }
  return L;
}

std::vector<double> net_flux(const FlowDomain& domain, const PressureNumbers& numbers, const FaceValues& v) {
  std::vector<double> flux(numbers.cell.size(), 0.0);
  for (const FaceKind kind : {FaceKind::open, FaceKind::prescribed}) {
    for_faces(domain, numbers, kind, [&](std::size_t axis, std::size_t face, int low, int high) {
      const double through = domain.area[axis][face] * v[axis][face];
      if (low >= 0) flux[at(low)] += through;
      if (high >= 0) flux[at(high)] -= through;
    });
  }
  return flux;
}

void add_pressure(const FlowDomain& domain, const PressureNumbers& numbers, std::span<const double> p, double by,
                  FaceValues& v) {
  for_faces(domain, numbers, FaceKind::open, [&](std::size_t axis, std::size_t face, int low, int high) {
    const double fall = (low < 0 ? 0 : p[at(low)]) - (high < 0 ? 0 : p[at(high)]);
    v[axis][face] += by * domain.area[axis][face] * fall / domain.volume[axis][face];
  });
}

void add_pressure_within(const FlowDomain& domain, const PressureNumbers& numbers, std::span<const double> p, double by,
                         FaceValues& v) {
  for_faces(domain, numbers, FaceKind::open, [&](std::size_t axis, std::size_t face, int low, int high) {
    if (low >= 0 && high >= 0)
      v[axis][face] += by * domain.area[axis][face] * (p[at(low)] - p[at(high)]) / domain.volume[axis][face];
  });
}

double kinetic_energy(const FlowDomain& domain, const FaceValues& v, const FaceValues& w, double density) {
  double energy = 0;
  for (std::size_t axis = 0; axis < at(domain.grid.dim); ++axis) {
    for (std::size_t face = 0; face < v[axis].size(); ++face) {
      if (domain.face[axis][face] == FaceKind::open)
        energy += 0.5 * density * domain.volume[axis][face] * v[axis][face] * w[axis][face];
    }
  }
  return energy;
}

double prescribed_power(const FlowDomain& domain, const PressureNumbers& numbers, std::span<const double> p,
                        const FaceValues& v) {
  double power = 0;
  for_faces(domain, numbers, FaceKind::prescribed, [&](std::size_t axis, std::size_t face, int low, int high) {
    const double fall = (low < 0 ? 0 : p[at(low)]) - (high < 0 ? 0 : p[at(high)]);
    power += fall * domain.area[axis][face] * v[axis][face];
  });
  return power;
}

}  // namespace tether::coupled
