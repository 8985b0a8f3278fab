// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/points/arrays.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>

#include "base/pages.hpp"
#include "grid/kernels.hpp"
#include "loops/points.hpp"
#include "physics/points/waits.hpp"

namespace tether::mpm {

static_assert(lists_each_array_once<Points>(Points::rows()), "an array of the points has no row, or two");

template <class Number>
void CellSort::permute(LineArray<Number>& array, Range range) {
  auto& scratch = std::get<LineArray<Number>>(scratch_);
  if (scratch.size() < keys_.size()) scratch.resize(keys_.size());  // points came in
  for (std::size_t k = 0; k < keys_.size(); ++k) scratch[k] = array[keys_[k].slot];
  std::copy_n(scratch.begin(), keys_.size(), array.begin() + static_cast<std::ptrdiff_t>(range.begin));
}

void CellSort::operator()(Points& P, Range range, const BackgroundGrid& shape) {
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

namespace {

/// Arrays that a scene asks for, more than every scene has.
std::vector<LineArray<double> Points::*> asked_by(const Scene& scene) {
  using P = Points;
  std::vector<LineArray<double> P::*> asked;
  const auto ask = [&](bool when, std::initializer_list<LineArray<double> P::*> arrays) {
    if (when) asked.insert(asked.end(), arrays);
  };
  const bool finite = find_body<FiniteElastic>(scene), gas = find_body<IdealGas>(scene),
             membrane = find_body<Membrane>(scene);
  const bool rubs = std::any_of(scene.bodies.begin(), scene.bodies.end(),
                                [](const Body& body) { return is_viscous_fluid(body.material); });
  const bool some_wait = std::any_of(scene.bodies.begin(), scene.bodies.end(), [&](const Body& body) {
    return waits(body.material, scene.method.order != StressOrder::usf);
  });
  ask(scene.method.transfer == Transfer::apic, {&P::vxx, &P::vyx, &P::vxy, &P::vyy});
  ask(scene.geometry == Geometry::axisymmetric || finite || membrane || rubs, {&P::szz});
  ask(gas, {&P::rho});
  ask(gas || rubs, {&P::energy});
  ask(membrane, {&P::strain, &P::hoop, &P::tx, &P::ty});
  ask(finite, {&P::fxx, &P::fxy, &P::fyx, &P::fyy, &P::fzz});
  ask(some_wait, {&P::dxx, &P::dyy, &P::dxy, &P::dzz});
  return asked;
}

}  // namespace

Points::Points(const Scene& scene, PointSet& given) {
  const std::size_t n = given.size();
  const auto take = [](LineArray<double>& array, std::vector<double>& of) {
    array.assign(of.begin(), of.end());
    std::vector<double>().swap(of);
    give_back_freed_memory();
  };
  take(x, given.x), take(y, given.y), take(vx, given.vx), take(vy, given.vy);
  take(mass, given.mass), take(volume, given.volume);
  take(sxx, given.sxx), take(syy, given.syy), take(sxy, given.sxy);
  for (const auto array : asked_by(scene)) (this->*array).resize(n);
  each_array([n](auto& array) { array.resize(n); });
  if (find_body<FiniteElastic>(scene)) {
    for (auto* array : {&fxx, &fyy, &fzz}) array->assign(size(), 1.0);
  }
  for (const std::size_t p : scene.pinned) pinned[p] = 1;
  std::iota(id.begin(), id.end(), 0);
}

namespace {

bool asks_nodes_for_density(const Scene& scene) {
  return std::any_of(scene.bodies.begin(), scene.bodies.end(), [](const Body& body) {
    const auto* gas = std::get_if<IdealGas>(&body.material);
    return gas && gas->rule == DensityRule::grid;
  });
}

}  // namespace

Grid::Grid(const Scene& scene, InstructionSet set)
    : frame(scene.grid, scene.walls, scene.geometry, scene.method.kernel, scene.edges, scene.strip.get()),
      sums(frame.shape.nodes()),
      motion(frame.shape.nodes(), 6),
      convected(frame.shape.nodes(), 10),
      gas(asks_nodes_for_density(scene) ? frame.shape.nodes() : 0, 12),
      loss(scene.method.ledger ? frame.shape.nodes() : 0, 14),
      squares(scene.method.ledger ? frame.shape.nodes() : 0, 15),
      active(frame.shape.nx, frame.shape.ny, frame.first_row, frame.last_row),
      ghosts(frame.ghosts),
      passes(node_passes(set)) {}

void Grid::list_ghosts() {
  ghosts.clear();
  std::copy_if(frame.ghosts.begin(), frame.ghosts.end(), std::back_inserter(ghosts),
               [&](const Ghost& ghost) { return active.any_around(static_cast<std::size_t>(ghost.node)); });
}

void fold_sums(std::span<const Ghost> ghosts, NodeSumsRow& sums) {
  for (const Ghost& ghost : ghosts) {
    NodeSumsAt from = sums[static_cast<std::size_t>(ghost.node)];
    NodeSumsAt to = sums[static_cast<std::size_t>(ghost.image)];
    to.m += from.m, to.gas += from.gas;
    to.momentum += ghost.sign * Pair(from.momentum);
    to.force += ghost.sign * Pair(from.force);
    from = NodeSums{};
  }
}

void Grid::fold_convected() {
  for (const Ghost& ghost : ghosts) {
    PairAt from = convected[static_cast<std::size_t>(ghost.node)];
    convected[static_cast<std::size_t>(ghost.image)] += ghost.sign * Pair(from);
    from = Pair{};
  }
}

void Grid::fold_loss() {
  for (const Ghost& ghost : ghosts) {
    double& from = loss[static_cast<std::size_t>(ghost.node)];
    loss[static_cast<std::size_t>(ghost.image)] += from;
    from = 0;
  }
}

void Grid::unfold_motion() {
  for (const Ghost& ghost : ghosts) {
    const NodeMotion image = motion[static_cast<std::size_t>(ghost.image)];
    motion[static_cast<std::size_t>(ghost.node)] = NodeMotion{ghost.sign * image.a, ghost.sign * image.u};
  }
}

void Grid::unfold_convected() {
  for (const Ghost& ghost : ghosts) {
    convected[static_cast<std::size_t>(ghost.node)] =
        ghost.sign * Pair(convected[static_cast<std::size_t>(ghost.image)]);
  }
}

void Grid::unfold_gas() {
  for (const Ghost& ghost : ghosts) {
    const auto n = static_cast<std::size_t>(ghost.node), image = static_cast<std::size_t>(ghost.image);
    gas.rho[n] = gas.rho[image], gas.heat[n] = gas.heat[image];
  }
}

void Grid::unfold_squares() {
  for (const Ghost& ghost : ghosts) {
    squares[static_cast<std::size_t>(ghost.node)] = squares[static_cast<std::size_t>(ghost.image)];
  }
}

}  // namespace tether::mpm
