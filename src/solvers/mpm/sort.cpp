// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/mpm/sort.hpp"

#include <algorithm>

#include "loops/points.hpp"

namespace tether::mpm {

CellSort::CellSort(std::size_t points) { keys_.reserve(points); }

template <class Number>
void CellSort::permute(std::vector<Number>& array, Range range) {
  auto& scratch = std::get<std::vector<Number>>(scratch_);
  if (scratch.size() < keys_.size()) scratch.resize(keys_.size());  // points came in
  for (std::size_t k = 0; k < keys_.size(); ++k) scratch[k] = array[keys_[k].slot];
  std::copy_n(scratch.begin(), keys_.size(), array.begin() + static_cast<std::ptrdiff_t>(range.begin));
}

void CellSort::operator()(Points& points, const std::vector<Range>& bodies, const Scene& scene,
                          const BackgroundGrid& shape) {
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const bool string = std::holds_alternative<Membrane>(scene.bodies[b].material);
    if (!string) sort_body(points, bodies[b], shape);
  }
}

void CellSort::sort_body(Points& P, Range range, const BackgroundGrid& shape) {
  const Locator locator(shape);
  keys_.clear();
  for_points(range, [&](std::size_t p) {
    const CellPlace at = locator.locate(P.x[p], P.y[p]);
    keys_.push_back({at.j * shape.cells_x() + at.i, P.id[p], p});
  });
  std::sort(keys_.begin(), keys_.end(),
            [](const Key& a, const Key& b) { return a.cell != b.cell ? a.cell < b.cell : a.id < b.id; });
  each_row(Points::rows(), [&](const auto& row) {
    if (row.remembered() && row.carried_by(P)) permute(P.*row.array, range);
  });
}

}  // namespace tether::mpm
