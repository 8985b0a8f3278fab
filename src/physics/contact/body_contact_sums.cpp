// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "algebra/dense.hpp"
#include "base/numbers.hpp"
#include "loops/elements.hpp"
#include "physics/contact/body_contact.hpp"
#include "physics/contact/plane_force.hpp"

namespace tether::contact {

// Sums over all that presses: forces, their derivatives, and what is reported of them.

namespace {

using Triplets = std::vector<Eigen::Triplet<double, std::int64_t>>;

/// Gathers the blocks of one side's pairs in a full matrix of the nodes that they have, of which there are few, before
/// they go to the sparse one: most pairs of a side have the same nodes.
template <int dim>
class SideMatrix {
 public:
  /// Adds a block of two places to those of the nodes that carry them.
  void add(const CarriedPlaces& places, int row, int column, const SmallMatrix<dim, dim>& block) {
    const auto rows = places.nodes(row), columns = places.nodes(column);
    const auto row_shares = places.shares(row), column_shares = places.shares(column);
    for (std::size_t a = 0; a < rows.size(); ++a) {
      const Eigen::Index i = dim * number_of(rows[a]);
      for (std::size_t b = 0; b < columns.size(); ++b) {
        const Eigen::Index j = dim * number_of(columns[b]);
        if (std::max(i, j) >= matrix_.rows()) grow();
        const double share = row_shares[a] * column_shares[b];
        for (int k = 0; k < dim; ++k) {
          for (int l = 0; l < dim; ++l) matrix_(i + l, j + k) += share * block(l, k);
        }
      }
    }
  }
  /// Hands all over, and begins again.
  void flush(double factor, bool convex, Triplets& numbers) {
    if (convex) make_convex();
    const auto count = static_cast<Eigen::Index>(nodes_.size());
    for (Eigen::Index b = 0; b < count; ++b) {
      for (Eigen::Index a = 0; a < count; ++a) {
        const auto block = matrix_.template block<dim, dim>(dim * a, dim * b);
        if ((block.array() == 0).all()) continue;
        for (int i = 0; i < dim; ++i) {
          for (int j = 0; j < dim; ++j)
            numbers.emplace_back(std::int64_t{nodes_[static_cast<std::size_t>(a)]} * dim + i,
                                 std::int64_t{nodes_[static_cast<std::size_t>(b)]} * dim + j, factor * block(i, j));
        }
      }
    }
    matrix_.topLeftCorner(dim * count, dim * count).setZero();
    nodes_.clear();
  }

 private:
  Eigen::Index number_of(int node) {
    const auto found = std::find(nodes_.begin(), nodes_.end(), node);
    if (found != nodes_.end()) return found - nodes_.begin();
    nodes_.push_back(node);
    return static_cast<Eigen::Index>(nodes_.size()) - 1;
  }
  void make_convex() {
    const auto rows = dim * static_cast<Eigen::Index>(nodes_.size());
    auto used = matrix_.topLeftCorner(rows, rows);
    used = convex_part(used);
  }
  void grow() {
    const Eigen::MatrixXd before = matrix_;
    matrix_ = Eigen::MatrixXd::Zero(2 * before.rows(), 2 * before.cols());
    matrix_.topLeftCorner(before.rows(), before.cols()) = before;
  }

  std::vector<int> nodes_;
  Eigen::MatrixXd matrix_ = Eigen::MatrixXd::Zero(16 * dim, 16 * dim);
};

}  // namespace

template <int dim>
void BodyContact::find_forces(const PairRule& rule, const Active& active, PlaceForces<dim>& forces) const {
  forces.force = decltype(forces.force)::Zero();
  if (rule.with_slopes) forces.slope = decltype(forces.slope)::Zero();
  const auto note = [&](const auto& found) {
    forces.pressing = found.pressing, forces.rubbing = found.rubbing, forces.rubbed = found.rubbed;
  };
  if (active.plane >= 0) {
    const ContactPoint& point = point_of(active.number);
    const std::size_t x = tether::at(point.place) * dim;
    const PairScale scale = scale_of(point, is_guard(active.number));
    const auto found = plane_force<dim>(rule, scale, contact_.planes[tether::at(active.plane)], &x0_[x], &x1_[x]);
    forces.places = {point.place, -1, -1, -1}, forces.count = 1, forces.force.col(0) = found.force;
    if (rule.with_slopes) forces.slope.template block<dim, dim>(0, 0) = found.slope;
    forces.energy = scale.strength * barrier(active.s1 / scale.gap2);
    forces.slid = 0;
    return note(found);
  }
  const ContactPair& pair = pairs_.pairs()[active.number];
  const PairScale scale = scale_of(pair);
  with_kind<dim>(pair.kind, [&](auto kind_of) {
    constexpr PairKind kind = decltype(kind_of)::value;
    constexpr int count = vector_count(kind);
    const auto r0 = vectors_of<kind, dim>(pair, x0_), r1 = vectors_of<kind, dim>(pair, x1_);
    PairRule own = rule;
    own.damped = rule.damped && active.damps;
    const auto found = pair_force<kind, dim>(own, scale, r0, r1, active.s0, active.s1);
    const auto by = vectors_by_places<kind>();
    forces.places = pair.places, forces.count = count + 1;
    forces.force.template block<dim, count + 1>(0, 0) = found.force * by;
    forces.energy = pair_energy<kind, dim>(scale, r1, active.s1);
    note(found);
    forces.slid = own.damped && active.s1 < scale.gap2 ? found.slid : 0;
    for (int p = 0; rule.with_slopes && p <= count; ++p) {
      for (int r = 0; r <= count; ++r) {
        for (int i = 0; i < count; ++i) {
          for (int j = 0; j < count; ++j)
            forces.slope.template block<dim, dim>(p * dim, r * dim) +=
                by(i, p) * by(j, r) * found.slope.template block<dim, dim>(i * dim, j * dim);
        }
      }
    }
  });
}

/// The side whose point or guard it is, or whose edge.
int BodyContact::side_of(const Active& active) const {
  return active.plane >= 0 ? point_of(active.number).side : pairs_.pairs()[active.number].side;
}

/// Calls add(k, forces) for all that is active, in its order.
template <int dim, class Add>
void BodyContact::each_force(bool with_slopes, const Add& add) const {
  PairRule rule = rule_;
  rule.with_slopes = with_slopes;
  compute_then_add<PlaceForces<dim>>(
      team_, active_.size(),
      [&](std::size_t k, PlaceForces<dim>& forces) { find_forces<dim>(rule, active_[k], forces); }, add);
}

void BodyContact::add_forces(std::span<const double> q1, std::span<double> f) {
  place(q1);
  place_forces_.assign(x1_.size(), 0.0);
  with_dim(surface_.dim(), [&](auto d) {
    constexpr int dim = decltype(d)::value;
    each_force<dim>(false, [&](std::size_t, const PlaceForces<dim>& forces) {
      for (int p = 0; p < forces.count; ++p)
        column_at<dim>(&place_forces_[tether::at(forces.places[tether::at(p)]) * dim]) += forces.force.col(p);
    });
  });
  surface_.places.add_to_nodes(place_forces_, f);
}

SparseMatrix BodyContact::with_slopes(const SparseMatrix& K, std::span<const double> q1, double factor) {
  place(q1);
  Triplets numbers;
  with_dim(surface_.dim(), [&](auto d) {
    constexpr int dim = decltype(d)::value;
    SideMatrix<dim> matrix;
    int side = -1;
    each_force<dim>(true, [&](std::size_t k, const PlaceForces<dim>& forces) {
      if (side_of(active_[k]) != side) matrix.flush(factor, convex_, numbers);
      side = side_of(active_[k]);
      for (int p = 0; p < forces.count; ++p) {
        for (int r = 0; r < forces.count; ++r)
          matrix.add(surface_.places, forces.places[tether::at(p)], forces.places[tether::at(r)],
                     forces.slope.template block<dim, dim>(p * dim, r * dim));
      }
    });
    matrix.flush(factor, convex_, numbers);
  });
  EigenSparse sum(K.n, K.n);
  sum.setFromTriplets(numbers.begin(), numbers.end());
  if (met_.rows() == K.n) sum += met_;
  met_ = sum, met_.coeffs().setZero();
  return sparse_of(eigen_of(K) + sum);
}

ContactNumbers BodyContact::numbers(std::span<const double> q1) {
  place(q1);
  ContactNumbers numbers;
  // Of each point of quadrature pressure, friction and distance.
  std::vector<std::array<double, 3>> points(surface_.points.size(), {0, 0, gap_});
  with_dim(surface_.dim(), [&](auto d) {
    constexpr int dim = decltype(d)::value;
    each_force<dim>(false, [&](std::size_t k, const PlaceForces<dim>& forces) {
      add_numbers<dim>(active_[k], forces, numbers, points);
    });
  });
  spread(points, numbers);
  return numbers;
}

/// Two bodies that meet press each other from both sides by half: a point of one feels half the pressure.
template <int dim>
void BodyContact::add_numbers(const Active& active, const PlaceForces<dim>& forces, ContactNumbers& numbers,
                              std::vector<std::array<double, 3>>& points) const {
  numbers.energy += forces.energy, numbers.rubbed += forces.rubbed;
  numbers.slid = std::max(numbers.slid, forces.slid);
  std::size_t number = active.number;
  double sign = 1, times = 1;
  bool at_a_point = !is_guard(number);
  if (active.plane < 0) {
    const ContactPair& pair = pairs_.pairs()[active.number];
    sign = pair.area < 0 ? -1 : 1, times = pair.side < 0 || pair.other < 0 ? 1 : 2;
    at_a_point = !pair.guard, number = pair.point;
  }
  numbers.pressing += sign * forces.pressing;
  if (!at_a_point) return;
  auto& [pressure, friction, distance] = points[number];
  pressure += sign * times * forces.pressing / surface_.points[number].area;
  friction += sign * times * forces.rubbing / surface_.points[number].area;
  distance = std::min(distance, std::sqrt(active.s1));
}

/// The means over the points of the sides that a node belongs to, by their shares of it; and what is least.
void BodyContact::spread(const std::vector<std::array<double, 3>>& points, ContactNumbers& numbers) const {
  const std::size_t nodes = solids_.mesh.node_count();
  std::vector<double> weight(nodes, 0.0);
  numbers.pressure.assign(nodes, 0.0), numbers.friction.assign(nodes, 0.0), numbers.distance.assign(nodes, gap_);
  std::vector<std::uint8_t> touched(surface_.side_nodes.size(), 0);
  double least = gap_;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const ContactPoint& point = surface_.points[k];
    const auto& [pressure, friction, distance] = points[k];
    const auto carriers = surface_.places.nodes(point.place);
    for (std::size_t a = 0; a < carriers.size(); ++a) {
      const auto node = tether::at(carriers[a]);
      const double part = point.area * std::abs(surface_.places.shares(point.place)[a]);
      weight[node] += part;
      numbers.pressure[node] += part * pressure, numbers.friction[node] += part * friction;
      numbers.distance[node] = std::min(numbers.distance[node], distance);
    }
    least = std::min(least, distance);
    if (distance < gap_) touched[tether::at(point.side)] = 1;
  }
  for (std::size_t n = 0; n < nodes; ++n) {
    if (weight[n] > 0) numbers.pressure[n] /= weight[n], numbers.friction[n] /= weight[n];
  }
  numbers.sides = static_cast<double>(std::count(touched.begin(), touched.end(), 1));
  numbers.least_gap = least < gap_ ? least : 0;
}

}  // namespace tether::contact
