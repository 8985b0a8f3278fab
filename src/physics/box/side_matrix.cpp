// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/side_matrix.hpp"

#include <algorithm>

#include "algebra/sparse_entries.hpp"
#include "base/blocks.hpp"
#include "base/numbers.hpp"

namespace tether::coupled {

/// The entries of each row, in the order of the lists, and where the nodes of each stand among the row's.
struct SideMatrix::Rows {
  std::vector<SideEntries> lists;
  std::vector<std::size_t> first;  // of each row, into entries
  std::vector<Entry> entries;
  std::vector<int> place;  // of each entry's nodes, one after the other
  std::size_t nodes = 0;   // of each entry
  CouplingMatrix zero;     // the matrix, of zeros

  void sort_by_rows(std::size_t rows);
};

void SideMatrix::Rows::sort_by_rows(std::size_t rows) {
  first.assign(rows + 1, 0);
  for (const auto& list : lists) {
    for (const SideEntry& entry : list.entries) ++first[at(entry.row) + 1];
  }
  for (std::size_t r = 0; r < rows; ++r) first[r + 1] += first[r];
  entries.resize(first.back());
  std::vector<std::size_t> next(first.begin(), first.end() - 1);
  for (const auto& list : lists) {
    for (const SideEntry& entry : list.entries)
      entries[next[at(entry.row)]++] = {entry.side, &list.values[entry.first]};
  }
}

std::span<const int> SideMatrix::nodes_of(int side) const {
  return where_ == EntriesAt::carriers ? surface_->carriers(at(side)) : surface_->side(at(side));
}

/// Where a node of the facet itself stands among those that have its entries.
std::size_t SideMatrix::place_of_own(int side, std::size_t node) const {
  const auto& parting = surface_->parting;
  return where_ == EntriesAt::carriers ? at(parting[at(side) % parting.size()][node]) : node;
}

SideMatrix::SideMatrix(Team& team, const SolidSurface& surface, EntriesAt where, std::vector<SideEntries> lists,
                       std::size_t rows, std::size_t columns)
    : surface_(&surface), where_(where) {
  const auto made = std::make_shared<Rows>();
  made->lists = std::move(lists);
  made->nodes = where == EntriesAt::carriers ? at(side_node_count_of(surface.kind)) : at(surface.dim);
  made->sort_by_rows(rows);
  made->place.resize(made->entries.size() * made->nodes);
  std::vector<std::vector<int>> nodes(rows);  // of each row, ascending
  each_block(team, rows, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) nodes[row] = place_nodes(row, *made);
  });
  made->zero = zeros(nodes, columns);
  rows_ = made;
}

/// Returns the nodes of a row, ascending, and finds where those of its entries stand among them.
std::vector<int> SideMatrix::place_nodes(std::size_t row, Rows& of) const {
  std::vector<int> nodes;
  for (std::size_t e = of.first[row]; e < of.first[row + 1]; ++e) {
    const auto side = nodes_of(of.entries[e].side);
    nodes.insert(nodes.end(), side.begin(), side.end());
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  for (std::size_t e = of.first[row]; e < of.first[row + 1]; ++e) {
    int* place = &of.place[e * of.nodes];
    for (const int node : nodes_of(of.entries[e].side))
      *place++ = static_cast<int>(std::lower_bound(nodes.begin(), nodes.end(), node) - nodes.begin());
  }
  return nodes;
}

CouplingMatrix SideMatrix::zeros(std::span<const std::vector<int>> nodes, std::size_t columns) const {
  CouplingMatrix zero(std::ssize(nodes), static_cast<std::int64_t>(columns));
  std::int64_t* start = zero.outerIndexPtr();
  start[0] = 0;
  for (std::size_t row = 0; row < nodes.size(); ++row)
    start[row + 1] = start[row] + std::ssize(nodes[row]) * surface_->dim;
  zero.resizeNonZeros(start[nodes.size()]);
  std::int64_t* column = zero.innerIndexPtr();
  for (const auto& of_row : nodes) {
    for (const int node : of_row) {
      for (int i = 0; i < surface_->dim; ++i) *column++ = std::int64_t{node} * surface_->dim + i;
    }
  }
  std::fill_n(zero.valuePtr(), zero.nonZeros(), 0.0);
  return zero;
}

/// fill(entry, places, values) adds an entry, whose nodes stand at these places among the row's, to the row's values.
template <class Fill>
CouplingMatrix SideMatrix::filled(Team& team, const Fill& fill) const {
  const Rows& of = *rows_;
  CouplingMatrix B = of.zero;
  each_block(team, of.first.size() - 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      double* values = B.valuePtr() + B.outerIndexPtr()[row];
      for (std::size_t e = of.first[row]; e < of.first[row + 1]; ++e)
        fill(of.entries[e], std::span(of.place).subspan(e * of.nodes, of.nodes), values);
    }
  });
  return B;
}

CouplingMatrix SideMatrix::with(Team& team, std::span<const Vec<3>> area) const {
  const std::size_t dim = at(surface_->dim);
  return filled(team, [&](const Entry& entry, std::span<const int> places, double* values) {
    const Vec<3>& A = area[at(entry.side)];
    for (std::size_t a = 0; a < places.size(); ++a) {
      for (std::size_t i = 0; i < dim; ++i) values[at(places[a]) * dim + i] += entry.W[3 * a + i] * A[i];
    }
  });
}

/// z . A of a facet has at its own nodes the slopes of slope_of_area(), with z the sum of W w over the facet's entries.
CouplingMatrix SideMatrix::slopes(Team& team, std::span<const double> places, std::span<const double> w) const {
  const std::size_t dim = at(surface_->dim);
  return filled(team, [&](const Entry& entry, std::span<const int> in_row, double* values) {
    const auto nodes = nodes_of(entry.side);
    Vec<3> z{};
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      for (std::size_t i = 0; i < dim; ++i) z[i] += entry.W[3 * a + i] * w[at(nodes[a]) * dim + i];
    }
    for (std::size_t k = 0; k < dim; ++k) {
      const Vec<3> slope = slope_of_area(*surface_, at(entry.side), places, k, z);
      const std::size_t first = at(in_row[place_of_own(entry.side, k)]) * dim;
      for (std::size_t i = 0; i < dim; ++i) values[first + i] += slope[i];
    }
  });
}

/// The sums of p W over the rows, 3 numbers for each node of each side.
std::vector<double> SideMatrix::times_of_sides(std::span<const double> p) const {
  const std::size_t numbers = 3 * rows_->nodes;
  std::vector<double> sums(surface_->side_count() * numbers, 0.0);
  for (std::size_t row = 0; row < p.size(); ++row) {
    for (std::size_t e = rows_->first[row]; e < rows_->first[row + 1]; ++e) {
      const Entry& entry = rows_->entries[e];
      double* to = &sums[at(entry.side) * numbers];
      for (std::size_t k = 0; k < numbers; ++k) to[k] += p[row] * entry.W[k];
    }
  }
  return sums;
}

void SideMatrix::add_force_slopes(std::span<const double> places, std::span<const double> p, double factor,
                                  SparseMatrix& K) const {
  const std::size_t dim = at(surface_->dim);
  const auto number = [&](int node, std::size_t axis) { return static_cast<std::int64_t>(at(node) * dim + axis); };
  const std::vector<double> sums = times_of_sides(p);
  const double* pressed = sums.data();  // sum of p W, of the node a of a side along i
  for (std::size_t side = 0; side < surface_->side_count(); ++side) {
    for (const int node : nodes_of(static_cast<int>(side))) {
      for (std::size_t i = 0; i < dim; ++i) {
        if (pressed[i] == 0) continue;
        Vec<3> z{};
        z[i] = factor * pressed[i];
        for (std::size_t k = 0; k < dim; ++k) {
          const Vec<3> slope = slope_of_area(*surface_, side, places, k, z);
          for (std::size_t j = 0; j < dim; ++j)
            add_to_entry(K, number(node, i), number(surface_->side(side)[k], j), slope[j]);
        }
      }
      pressed += 3;
    }
  }
}

}  // namespace tether::coupled
