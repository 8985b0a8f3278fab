// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/solids/body_doubts.hpp"

#include <fmt/format.h>
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <variant>

#include "base/numbers.hpp"
#include "base/vec.hpp"
#include "grid/shapes.hpp"

namespace tether::fem {
namespace {

/// Strain that a linear law may leave out: a turn by 18 degrees alone makes as much, and cantilevers under their weight
/// sag 4 % too far.
constexpr double most_left_out = 0.05;

/// Part of the grid's extent by which a node may be beyond its edge.
constexpr double grazing = 1e-3;

/// Half the largest entry of (grad u)^T grad u in the middle of an element: Green's strain less the linear one.
template <class Shapes>
double left_out_of(const Mesh& mesh, std::size_t e, std::span<const double> q) {
  constexpr int dim = Shapes::dim;
  Vec<dim> middle{};
  for (int k = 0; k < Shapes::points; ++k) {
    for (int i = 0; i < dim; ++i) middle[at(i)] += Shapes::place(k)[at(i)] / Shapes::points;
  }
  const auto map = jacobian_at<Shapes>(mesh, e, middle);
  Eigen::Matrix<double, dim, dim> slope = Eigen::Matrix<double, dim, dim>::Zero();
  for (int a = 0; a < Shapes::nodes; ++a) {
    const std::size_t n = dim * at(mesh.element(e)[a]);
    for (int i = 0; i < dim; ++i) {
      const double u = q[n + at(i)] - mesh.x[n + at(i)];
      for (int j = 0; j < dim; ++j) slope(i, j) += u * map.gradients[at(a * dim + j)];
    }
  }
  return 0.5 * (slope.transpose() * slope).cwiseAbs().maxCoeff();
}

}  // namespace

BodyDoubts::BodyDoubts(const Solids& solids, const BackgroundGrid& grid) : solids_(solids), grid_(grid) {
  for (std::size_t e = 0; e < solids.mesh.element_count(); ++e) {
    if (std::holds_alternative<LinearElastic>(solids.regions[at(solids.mesh.region[e])].law)) linear_.push_back(e);
  }
  const std::vector<int> part = parts_of(solids.mesh);
  std::vector<bool> held(at(count_parts(solids.mesh)), false);
  for (const Support& support : solids.supports) {
    for (const int n : support.nodes) {
      if (part[at(n)] >= 0) held[at(part[at(n)])] = true;
    }
  }
  for (const int p : part) free_.push_back(p >= 0 && !held[at(p)]);
}

void BodyDoubts::look(std::span<const double> q, double time, BodyDoubtNumbers& doubts,
                      std::vector<std::string>& messages) const {
  look_at_edges(q, time, doubts, messages);
  look_at_turns(q, time, doubts, messages);
}

/// Nodes that stand at an edge at the start, held there or not, are as the deck wants them; bodies that something holds
/// go no further than it lets them.
void BodyDoubts::look_at_edges(std::span<const double> q, double time, BodyDoubtNumbers& doubts,
                               std::vector<std::string>& messages) const {
  if (is_warned(doubts.warned, BodyDoubt::left_grid)) return;
  const auto dim = at(solids_.mesh.dim());
  const Vec<2> low{grid_.x0, grid_.y0}, high{grid_.x1, grid_.y1};
  constexpr std::array<std::array<const char*, 2>, 2> names{{{"xleft", "xright"}, {"ybot", "ytop"}}};
  for (std::size_t k = 0; k < q.size(); ++k) {
    const std::size_t i = k % dim;
    if (i > 1) continue;
    const double x0 = solids_.mesh.x[k], far = grazing * (high[i] - low[i]);
    const bool out = q[k] < low[i] - far || q[k] > high[i] + far;
    if (!out || !(x0 > low[i] && x0 < high[i]) || !free_[k / dim]) continue;
    const bool up = q[k] > high[i];
    const std::size_t first = k - i;
    messages.push_back(fmt::format(
        "t = {:.6g}: node {} of {}, at ({:.6g}, {:.6g}), has left the grid beyond {} = {:.6g}: the grid's walls hold "
        "nodes that stand at them at the start and stop no others; fix_on of $fem holds a body, walls of $coupled stop "
        "it",
        time, k / dim + 1, region_of_node(k / dim), q[first], q[first + 1], names[i][up ? 1 : 0],
        up ? high[i] : low[i]));
    note_warning(doubts.warned, BodyDoubt::left_grid);
    return;
  }
}

void BodyDoubts::look_at_turns(std::span<const double> q, double time, BodyDoubtNumbers& doubts,
                               std::vector<std::string>& messages) const {
  if (is_warned(doubts.warned, BodyDoubt::turned)) return;
  double most = 0;
  std::size_t worst = 0;
  for (const std::size_t e : linear_) {
    if (const double strain = left_out(e, q); strain > most) most = strain, worst = e;
  }
  if (!(most > most_left_out)) return;
  messages.push_back(fmt::format(
      "t = {:.6g}: law='linear' leaves out strains of {:.2g} in element {} of {}, as much as a turn by {:.0f} degrees "
      "makes: it holds for small turns alone, law='svk' for any",
      time, most, worst + 1, solids_.regions[at(solids_.mesh.region[worst])].name,
      std::acos(std::max(1 - most, -1.0)) * 180 / M_PI));
  note_warning(doubts.warned, BodyDoubt::turned);
}

/// A vibration of n steps a period turns back in 2 of n; steps longer than its period turn it back every time.
void BodyDoubts::look_at_swings(std::span<const double> v0, std::span<const double> v1, std::span<const double> masses,
                                double least, double time, BodyDoubtNumbers& doubts,
                                std::vector<std::string>& messages) {
  constexpr double moving = 1e-3, most = 0.6;  // part of the largest energy; of steps that turn back
  constexpr long long fewest = 4;
  if (is_warned(doubts.warned, BodyDoubt::swings)) return;
  const std::size_t dim = v0.size() / masses.size();
  double before = 0, after = 0, both = 0;
  for (std::size_t k = 0; k < v0.size(); ++k) {
    const double m = masses[k / dim];
    before += m * v0[k] * v0[k], after += m * v1[k] * v1[k], both += m * v0[k] * v1[k];
  }
  doubts.fastest = std::max({doubts.fastest, before, after});
  if (!(std::min(before, after) > std::max(moving * doubts.fastest, 2 * least))) return;
  ++doubts.looks, doubts.reversals += both < 0 ? 1 : 0;
  if (doubts.reversals < fewest || static_cast<double>(doubts.reversals) < most * static_cast<double>(doubts.looks))
    return;
  messages.push_back(fmt::format(
      "t = {:.6g}: in {} of {} steps the bodies' velocity turned back: steps are longer than half the period of what "
      "vibrates, whose period and place are then those of the steps; a tenth of the period or less follows it",
      time, doubts.reversals, doubts.looks));
  note_warning(doubts.warned, BodyDoubt::swings);
}

void BodyDoubts::look_at_balance(double residual, std::span<const double> q, std::span<const double> x, double time,
                                 BodyDoubtNumbers& doubts, std::vector<std::string>& messages) {
  constexpr double still = 1e-12;
  if (!(residual > most_unbalanced) || is_warned(doubts.warned, BodyDoubt::unbalanced)) return;
  double way = 0, extent = 0;
  for (std::size_t k = 0; k < q.size(); ++k)
    way = std::max(way, std::abs(q[k] - x[k])), extent = std::max(extent, std::abs(x[k]));
  if (way <= still * extent) return;
  messages.push_back(fmt::format(
      "t = {:.6g}: forces of the equilibrium balance to {:.2g} of the largest of them alone, as rounding of a body so "
      "stiff against its bending, or of parts so different in stiffness, leaves no less: places and forces are off by "
      "as much or more",
      time, residual));
  note_warning(doubts.warned, BodyDoubt::unbalanced);
}

double BodyDoubts::left_out(std::size_t e, std::span<const double> q) const {
  return with_shapes(solids_.mesh.kind, [&](auto shapes) { return left_out_of<decltype(shapes)>(solids_.mesh, e, q); });
}

std::string BodyDoubts::region_of_node(std::size_t node) const {
  const Mesh& mesh = solids_.mesh;
  const auto found = std::ranges::find(mesh.nodes, static_cast<int>(node));
  const auto e = static_cast<std::size_t>(found - mesh.nodes.begin()) / at(node_count_of(mesh.kind));
  return e < mesh.element_count() ? solids_.regions[at(mesh.region[e])].name : std::string("no element");
}

/// "body 2 (region 1)", by the region of the body's first element.
std::string BodyOverlaps::name_of(int part) const {
  const Mesh& mesh = solids_.mesh;
  const std::vector<int> parts = parts_of(mesh);
  std::size_t e = 0;
  while (parts[at(mesh.element(e)[0])] != part) ++e;
  return fmt::format("body {} ({})", part + 1, solids_.regions[at(mesh.region[e])].name);
}

void BodyOverlaps::look(std::span<const double> q, double time, OverlapCount& count,
                        std::vector<std::string>& messages) {
  const Overlap found = finder_.find(q);
  count.now = static_cast<long long>(found.nodes);
  if (count.now > 0 && count.most == 0) {
    const bool own = found.part == found.other;
    const Vec<3>& x = found.place;
    messages.push_back(fmt::format(
        "t = {:.6g}: node {} of {} at ({:.6g}, {:.6g}{}) lies inside {}: nothing stops bodies at one another, what "
        "follows is wrong where they overlap (nodes_inside counts such nodes)",
        time, found.node + 1, name_of(found.part), x[0], x[1],
        solids_.mesh.dim() == 3 ? fmt::format(", {:.6g}", x[2]) : "",
        own ? std::string("that body, which has come through itself") : name_of(found.other)));
  }
  count.most = std::max(count.most, count.now);
}

}  // namespace tether::fem
