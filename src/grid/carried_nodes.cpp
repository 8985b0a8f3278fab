// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/carried_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "algebra/dense.hpp"
#include "base/numbers.hpp"

namespace tether {
namespace {

/// How far apart carried nodes are to stand at the most, over the distance of the fluid's: further apart, fluid goes
/// through.
constexpr double furthest = 1.4;

/// How long the intervals of a way count over the fluid's nodes: as in the mean across it, but none is to leave nodes
/// too far apart anywhere.
std::vector<double> lengths_of(const std::vector<double>& sum, const std::vector<double>& count,
                               const std::vector<double>& most) {
  std::vector<double> lengths(sum.size());
  for (std::size_t i = 0; i < lengths.size(); ++i)
    lengths[i] = count[i] > 0 ? std::max(sum[i] / count[i], most[i] / furthest) : 0;
  return lengths;
}

/// Of elements of thin bodies.
constexpr double longest_over_thickness = 4;

/// Lines that divide a way into so many parts, as equal as its intervals of these lengths let them be.
std::vector<std::size_t> lines_of_parts(const std::vector<double>& lengths, double length, std::size_t parts) {
  const std::size_t intervals = lengths.size();
  std::vector<std::size_t> lines{0};
  std::size_t line = 0;
  double reached = 0;
  for (std::size_t k = 1; k <= parts; ++k) {
    const double due = length * static_cast<double>(k) / static_cast<double>(parts);
    const std::size_t first = lines.back() + 1, last = k == parts ? intervals : intervals - (parts - k);
    while (line < last && (line < first || k == parts || reached + 0.5 * lengths[line] < due))
      reached += lengths[line++];
    lines.push_back(line);
  }
  return lines;
}

double longest_part(const std::vector<double>& lengths, const std::vector<std::size_t>& lines) {
  double longest = 0;
  for (std::size_t k = 1; k < lines.size(); ++k) {
    const auto from = lengths.begin() + static_cast<std::ptrdiff_t>(lines[k - 1]);
    longest =
        std::max(longest, std::accumulate(from, from + static_cast<std::ptrdiff_t>(lines[k] - lines[k - 1]), 0.0));
  }
  return longest;
}

/// The lines of a way whose intervals are so many of the fluid's nodes long: of biquadratic elements of about a cell of
/// the fluid, as many as there are to be, or more where one would be too long; all lines where there are no more.
std::vector<std::size_t> lines_of(const std::vector<double>& lengths, double least_elements) {
  const std::size_t intervals = lengths.size();
  const double length = std::accumulate(lengths.begin(), lengths.end(), 0.0);
  const double most = std::max(furthest, 1.001 * *std::ranges::max_element(lengths));
  auto parts = 2 * static_cast<std::size_t>(std::max(std::round(0.5 * length), std::ceil(least_elements)));
  for (; parts < intervals && length > 0; parts += 2) {
    std::vector<std::size_t> lines = lines_of_parts(lengths, length, parts);
    if (longest_part(lengths, lines) <= most) return lines;
  }
  std::vector<std::size_t> all(intervals + 1);
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

/// Values at t of the functions of three places.
std::array<double, 3> quadratic(const std::array<double, 3>& at, double t) {
  std::array<double, 3> values;
  for (std::size_t k = 0; k < 3; ++k) {
    const double a = at[(k + 1) % 3], b = at[(k + 2) % 3];
    values[k] = (t - a) * (t - b) / ((at[k] - a) * (at[k] - b));
  }
  return values;
}

std::vector<NodeLattice> lattices_but(const Mesh& bodies, const std::vector<bool>& whole) {
  std::vector<NodeLattice> lattices = node_lattices_of(bodies);
  std::erase_if(lattices, [&](const NodeLattice& lattice) {
    return !whole.empty() && whole[at(bodies.region[lattice.first_element])];
  });
  return lattices;
}

}  // namespace

CarriedNodes::CarriedNodes(const Mesh& fluid, const Mesh& bodies, const std::vector<bool>& whole)
    : bodies_(bodies),
      spacings_(fluid),
      lattices_(lattices_but(bodies, whole)),
      chains_of_(chains_of(lattices_)),
      lattice_of_(bodies.element_count(), -1),
      below_(bodies.element_count(), -1),
      chains_(chains_of_.lines.size()) {
  for (std::size_t l = 0; l < lattices_.size(); ++l) {
    const auto [first, second] = lattices_[l].elements;
    std::fill_n(lattice_of_.begin() + static_cast<std::ptrdiff_t>(lattices_[l].first_element), first * second,
                static_cast<int>(l));
    const std::array lengths{places_of_way(l, 0).back(), places_of_way(l, 1).back()};
    for (std::size_t way = 0; way < 2; ++way) {
      double& least = chains_[at(chains_of_.of[l][way].chain)].least_elements;
      least = std::max(least, lengths[way] / (longest_over_thickness * lengths[1 - way]));
    }
  }
}

void CarriedNodes::choose(std::span<const double> x) {
  measure(x);
  bool changed = nodes_.empty();
  for (Chain& chain : chains_) {
    std::vector<std::size_t> lines = lines_of(lengths_of(chain.sum, chain.count, chain.most), chain.least_elements);
    changed |= lines != chain.lines;
    chain.lines = std::move(lines);
  }
  if (changed) rebuild();
  coarsest_ = coarsest_loose_;
  for (const Chain& chain : chains_) {
    for (std::size_t k = 1; k < chain.lines.size(); ++k) {
      double distance = 0;
      for (std::size_t i = chain.lines[k - 1]; i < chain.lines[k]; ++i) distance += chain.most[i];
      coarsest_ = std::max(coarsest_, distance);
    }
  }
}

void CarriedNodes::measure(std::span<const double> x) {
  for (std::size_t c = 0; c < chains_.size(); ++c) {
    for (auto* numbers : {&chains_[c].sum, &chains_[c].most, &chains_[c].count})
      numbers->assign(chains_of_.lines[c] - 1, 0.0);
  }
  coarsest_loose_ = 0;
  for (std::size_t e = 0; e < bodies_.element_count(); ++e) {
    if (const auto spacing = spacings_.of_element(bodies_, x, e, below_[e])) measure_element(e, *spacing);
  }
}

void CarriedNodes::measure_element(std::size_t e, const std::array<NodeSpacing, 4>& spacing) {
  if (lattice_of_[e] < 0) {
    for (const NodeSpacing& edge : spacing) coarsest_loose_ = std::max(coarsest_loose_, edge.ratio());
    return;
  }
  const std::size_t l = at(lattice_of_[e]), order = at(order_of(bodies_.kind));
  const std::size_t k = e - lattices_[l].first_element;
  const std::array<std::size_t, 2> place{k % lattices_[l].elements[0], k / lattices_[l].elements[0]};
  for (std::size_t way = 0; way < 2; ++way) {
    const auto [chain, reversed] = chains_of_.of[l][way];
    Chain& of = chains_[at(chain)];
    const double ratio = 0.5 * (spacing[way].ratio() + spacing[way + 2].ratio());
    for (std::size_t i = order * place[way]; i < order * (place[way] + 1); ++i) {
      const std::size_t interval = reversed ? of.most.size() - 1 - i : i;
      of.sum[interval] += ratio, of.count[interval] += 1;
      of.most[interval] = std::max(of.most[interval], ratio);
    }
  }
}

/// Returns where the lines of a way stand in the mean over those across it, in the reference shape [length].
std::vector<double> CarriedNodes::places_of_way(std::size_t l, std::size_t way) const {
  const NodeLattice& lattice = lattices_[l];
  const auto place = [&](std::size_t i, std::size_t j) {
    return &bodies_.x[2 * at(way == 0 ? lattice.node(i, j) : lattice.node(j, i))];
  };
  std::vector<double> t(lattice.count[way], 0.0);
  for (std::size_t i = 1; i < t.size(); ++i) {
    double sum = 0;
    for (std::size_t j = 0; j < lattice.count[1 - way]; ++j)
      sum += std::hypot(place(i, j)[0] - place(i - 1, j)[0], place(i, j)[1] - place(i - 1, j)[1]);
    t[i] = t[i - 1] + sum / static_cast<double>(lattice.count[1 - way]);
  }
  return t;
}

/// Returns for each line of a way the lines taken that it follows.
std::vector<CarriedNodes::Row> CarriedNodes::rows_of_way(std::size_t l, std::size_t way) const {
  const auto [chain, reversed] = chains_of_.of[l][way];
  std::vector<std::size_t> lines = chains_[at(chain)].lines;
  const std::size_t count = lattices_[l].count[way];
  for (std::size_t& line : lines) line = reversed ? count - 1 - line : line;
  std::ranges::sort(lines);
  std::vector<Row> rows(count);
  for (const std::size_t line : lines) rows[line] = {{static_cast<int>(line), 1.0}};
  if (lines.size() == count) return rows;
  const std::vector<double> t = places_of_way(l, way);
  for (std::size_t part = 0; part + 2 < lines.size(); part += 2) {
    const std::array<std::size_t, 3> of{lines[part], lines[part + 1], lines[part + 2]};
    for (std::size_t i = of[0]; i < of[2]; ++i) {
      if (!rows[i].empty()) continue;
      const auto values = quadratic({t[of[0]], t[of[1]], t[of[2]]}, t[i]);
      for (std::size_t k = 0; k < 3; ++k) rows[i].emplace_back(static_cast<int>(of[k]), values[k]);
    }
  }
  return rows;
}

/// Adds the rows of a lattice's nodes; those of the lattices before it keep theirs.
void CarriedNodes::add_rows(std::size_t l, std::vector<Row>& rows) const {
  const NodeLattice& lattice = lattices_[l];
  const std::vector<Row> first = rows_of_way(l, 0), second = rows_of_way(l, 1);
  for (std::size_t j = 0; j < lattice.count[1]; ++j) {
    for (std::size_t i = 0; i < lattice.count[0]; ++i) {
      Row& row = rows[at(lattice.node(i, j))];
      if (!row.empty()) continue;
      for (const auto& [line_j, part_j] : second[j]) {
        for (const auto& [line_i, part_i] : first[i])
          row.emplace_back(lattice.node(at(line_i), at(line_j)), part_i * part_j);
      }
      keep_linear_fields(lattice.node(i, j), row);
    }
  }
}

/// The least change of the parts after which they give back a field that is linear in the reference shape, as rigid
/// motions are, where the body's lines are curved: sum of changes 0, sum of changes times places what is missing.
void CarriedNodes::keep_linear_fields(int node, Row& row) const {
  const auto size = static_cast<Eigen::Index>(row.size());
  if (size < 2) return;
  Eigen::MatrixXd A(3, size);
  Eigen::Vector3d missing(0, bodies_.x[2 * at(node)], bodies_.x[2 * at(node) + 1]);
  for (Eigen::Index k = 0; k < size; ++k) {
    const auto& [carried, part] = row[static_cast<std::size_t>(k)];
    A.col(k) << 1, bodies_.x[2 * at(carried)], bodies_.x[2 * at(carried) + 1];
    missing.tail<2>() -= part * A.col(k).tail<2>();
  }
  if (missing.norm() <= 1e-13 * A.bottomRows<2>().norm()) return;
  const Eigen::VectorXd change = smallest_solution(A, missing);
  for (Eigen::Index k = 0; k < size; ++k) row[static_cast<std::size_t>(k)].second += change[k];
}

void CarriedNodes::rebuild() {
  std::vector<Row> rows(bodies_.node_count());
  for (std::size_t l = 0; l < lattices_.size(); ++l) add_rows(l, rows);
  fill(rows);
}

/// A node that others follow is carried, as is one that follows none.
void CarriedNodes::fill(const std::vector<Row>& rows) {
  std::vector<int> number(rows.size(), -1);
  for (std::size_t n = 0; n < rows.size(); ++n) {
    if (rows[n].empty()) number[n] = 0;
    for (const auto& [carried, part] : rows[n]) number[at(carried)] = 0;
  }
  nodes_.clear();
  for (std::size_t n = 0; n < rows.size(); ++n) {
    if (number[n] < 0) continue;
    number[n] = static_cast<int>(nodes_.size());
    nodes_.push_back(static_cast<int>(n));
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t n = 0; n < rows.size(); ++n) {
    const Row own{{static_cast<int>(n), 1.0}};
    for (const auto& [carried, part] : number[n] >= 0 ? own : rows[n]) {
      for (int i = 0; i < 2; ++i) entries.emplace_back(2 * static_cast<int>(n) + i, 2 * number[at(carried)] + i, part);
    }
  }
  following_.resize(static_cast<Eigen::Index>(2 * rows.size()), static_cast<Eigen::Index>(2 * nodes_.size()));
  following_.setFromTriplets(entries.begin(), entries.end());
}

void CarriedNodes::follow(std::span<const double> carried, std::span<double> V) const {
  Eigen::Map<Eigen::VectorXd>(V.data(), following_.rows()) =
      following_ * Eigen::Map<const Eigen::VectorXd>(carried.data(), following_.cols());
}

void CarriedNodes::gather(std::span<const double> F, std::span<double> carried) const {
  Eigen::Map<Eigen::VectorXd>(carried.data(), following_.cols()) =
      following_.transpose() * Eigen::Map<const Eigen::VectorXd>(F.data(), following_.rows());
}

}  // namespace tether
