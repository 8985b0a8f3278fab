// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/side_sums.hpp"

#include <algorithm>

#include "base/blocks.hpp"
#include "base/numbers.hpp"

namespace tether::coupled {
namespace {

/// An entry and its numbers.
struct Found {
  int side = 0;
  const double* value = nullptr;
};

/// The entries of each row, in the order of the lists.
class EntriesOfRows {
 public:
  EntriesOfRows(std::span<const SideEntries> lists, std::size_t rows) : first_(rows + 1, 0) {
    for (const auto& list : lists) {
      for (const SideEntry& entry : list.entries) ++first_[at(entry.row) + 1];
    }
    for (std::size_t r = 0; r < rows; ++r) first_[r + 1] += first_[r];
    entries_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (const auto& list : lists) {
      for (const SideEntry& entry : list.entries)
        entries_[next[at(entry.row)]++] = {entry.side, &list.values[entry.first]};
    }
  }
  std::span<const Found> operator[](std::size_t row) const {
    return std::span(entries_).subspan(first_[row], first_[row + 1] - first_[row]);
  }

 private:
  std::vector<std::size_t> first_;
  std::vector<Found> entries_;
};

/// The nodes of a row's sides, ascending.
void find_nodes(const SolidSurface& surface, std::span<const Found> entries, std::vector<int>& nodes) {
  nodes.clear();
  for (const Found& entry : entries) {
    const auto side = surface.carriers(at(entry.side));
    nodes.insert(nodes.end(), side.begin(), side.end());
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
}

/// Columns and values of a row.
void fill_row(const SolidSurface& surface, std::span<const Found> entries, std::span<const int> nodes,
              std::int64_t* column, double* value) {
  const std::size_t dim = at(surface.dim);
  for (std::size_t k = 0; k < nodes.size() * dim; ++k)
    column[k] = nodes[k / dim] * surface.dim + static_cast<std::int64_t>(k % dim), value[k] = 0;
  for (const Found& entry : entries) {
    const auto side = surface.carriers(at(entry.side));
    for (std::size_t a = 0; a < side.size(); ++a) {
      const auto place =
          static_cast<std::size_t>(std::lower_bound(nodes.begin(), nodes.end(), side[a]) - nodes.begin());
      for (std::size_t i = 0; i < dim; ++i) value[place * dim + i] += entry.value[3 * a + i];
    }
  }
}

}  // namespace

CouplingMatrix matrix_of_sides(Team& team, const SolidSurface& surface, std::span<const SideEntries> lists,
                               std::size_t rows, std::size_t columns) {
  const EntriesOfRows of(lists, rows);
  CouplingMatrix B(static_cast<std::int64_t>(rows), static_cast<std::int64_t>(columns));
  std::int64_t* start = B.outerIndexPtr();
  each_block(team, rows, [&](std::size_t begin, std::size_t end) {
    std::vector<int> nodes;
    for (std::size_t row = begin; row < end; ++row) {
      find_nodes(surface, of[row], nodes);
      start[row + 1] = std::ssize(nodes) * surface.dim;
    }
  });
  start[0] = 0;
  for (std::size_t row = 0; row < rows; ++row) start[row + 1] += start[row];
  B.resizeNonZeros(start[rows]);
  each_block(team, rows, [&](std::size_t begin, std::size_t end) {
    std::vector<int> nodes;
    for (std::size_t row = begin; row < end; ++row) {
      find_nodes(surface, of[row], nodes);
      fill_row(surface, of[row], nodes, B.innerIndexPtr() + start[row], B.valuePtr() + start[row]);
    }
  });
  return B;
}

}  // namespace tether::coupled
