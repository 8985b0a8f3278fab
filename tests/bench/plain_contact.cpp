// SPDX-License-Identifier: GPL-3.0-or-later
// The robust step of two elastic disks that touch and slide, as a plain loop: a grid a body, and where both have mass
// an impulse along the normal takes the approach of points that touch away. PROGRAM elastic [cells ...], see
// plain::Words.
#include <limits>

#include "robust.hpp"

namespace {

constexpr plain::Features features{};
using plain::Pair;

/// The scene of contact.in, of which a cell is `h`: disks that touch, their velocities and the way between the centres.
constexpr double radius = 0.25;
constexpr std::array<Pair, 2> centres{{{0.26, 0.43}, {0.74, 0.57}}}, velocities{{{0.5, -0.5}, {-0.5, 0.5}}};

std::vector<plain::Point> disk(const plain::Block& block, std::size_t b) {
  auto points = plain::within(points_of(block), block, centres[b].x, centres[b].y, radius);
  for (plain::Point& p : points) {
    p.vx = velocities[b].x, p.vy = velocities[b].y;
    p.vxx = p.vyx = p.vxy = p.vyy = 0;
  }
  return points;
}

/// A node with mass of both bodies, and what the points around it say.
struct Shared {
  std::size_t node;
  std::array<double, 2> m{}, weight{};  // masses; sums of N m
  std::array<Pair, 2> middle{};         // sums of N m x
  Pair place{}, normal{};               // the normal points from body 0 to 1
  std::array<double, 2> reach{};        // of either body towards the other along it, from the node
};

class Contact {
 public:
  explicit Contact(const plain::Block& block)
      : grids_{Grid(block), Grid(block)}, bodies_{Body(block, disk(block, 0)), Body(block, disk(block, 1))} {
    slot_.assign(grids_[0].sums.size(), -1), near_.assign(slot_.size(), 0);
    for (std::size_t b = 0; b < 2; ++b)
      for (std::size_t p = 0; p < bodies_[b].size(); ++p) bodies_[b].map(p, grids_[b]);
  }
  std::size_t size() const { return bodies_[0].size() + bodies_[1].size(); }
  void step() {
    find_shared();
    for (std::size_t b = 0; b < 2; ++b) pull(b);
    for (std::size_t b = 0; b < 2; ++b) grids_[b].solve(bodies_[b].P.dt);
    find_normals();
    for (std::size_t b = 0; b < 2; ++b) find_reach(b);
    for (const Shared& s : shared_) push_apart(s);
    for (std::size_t b = 0; b < 2; ++b)
      for (std::size_t p = 0; p < bodies_[b].size(); ++p) bodies_[b].move(p, grids_[b]);
  }
  plain::Totals totals() const {
    plain::Totals totals;
    for (const Grid& grid : grids_) grid.add_to(totals);
    totals.lost = lost_;
    return totals;
  }

 private:
  using Grid = plain::Nodes<features>;
  using Body = plain::Body<features>;

  /// Nodes with mass of both bodies, and which middle nodes have them among their nine.
  void find_shared() {
    const auto nx = static_cast<std::size_t>(grids_[0].nx);
    const double h = grids_[0].h;
    for (const Shared& s : shared_) {
      slot_[s.node] = -1;
      mark(s.node, 0);
    }
    shared_.clear();
    for (Grid& grid : grids_) grid.begin();
    for (std::size_t n = 0; n < slot_.size(); ++n) {
      const double a = grids_[0].sums[n].m, b = grids_[1].sums[n].m;
      if (!(a > 0 && b > 0)) continue;
      slot_[n] = static_cast<int>(shared_.size());
      shared_.push_back({.node = n, .m = {a, b}});
      shared_.back().place = {static_cast<double>(n % nx) * h, static_cast<double>(n / nx) * h};
    }
    for (const Shared& s : shared_) mark(s.node, 1);
  }
  /// Places are numbered by the first of their nine nodes.
  void mark(std::size_t node, char value) {
    for (std::size_t l = 0; l < 3; ++l)
      for (std::size_t k = 0; k < 3; ++k) near_[node - l * grids_[0].width() - k] = value;
  }
  /// Strain rates, stresses and forces; points near shared nodes are kept and give their place there.
  void pull(std::size_t b) {
    near_points_[b].clear();
    for (std::size_t p = 0; p < bodies_[b].size(); ++p) {
      const plain::At here = bodies_[b].at(p, grids_[b]);
      if (near_[here.node]) near_points_[b].push_back(p);
      bodies_[b].pull(p, here, grids_[b]);
    }
    for (const std::size_t p : near_points_[b]) {
      const double x = bodies_[b].P.x[p], y = bodies_[b].P.y[p], m = bodies_[b].P.m[p];
      each_shared(b, p, [&](Shared& s, double N) {
        s.weight[b] += N * m, s.middle[b].x += N * m * x, s.middle[b].y += N * m * y;
      });
    }
  }
  /// Calls visit(shared node, N) for the shared ones of a point's nodes.
  template <class Visit>
  void each_shared(std::size_t b, std::size_t p, const Visit& visit) {
    const plain::At here = bodies_[b].at(p, grids_[b]);
    for (std::size_t l = 0; l < 3; ++l)
      for (std::size_t k = 0; k < 3; ++k) {
        const int slot = slot_[grids_[b].row(here, l) + k];
        if (slot >= 0) visit(shared_[static_cast<std::size_t>(slot)], here.x.w[k] * here.y.w[l]);
      }
  }
  /// From middle to middle of the bodies' points around the node.
  void find_normals() {
    for (Shared& s : shared_) {
      s.reach.fill(-std::numeric_limits<double>::infinity());
      const double x = s.middle[1].x / s.weight[1] - s.middle[0].x / s.weight[0];
      const double y = s.middle[1].y / s.weight[1] - s.middle[0].y / s.weight[0];
      const double length = std::sqrt(x * x + y * y);
      if (length > 0) s.normal = {x / length, y / length};
    }
  }
  /// How far points no more than half a cell aside reach along the normal; a point's radius is half its distance.
  void find_reach(std::size_t b) {
    const double sense = b == 0 ? 1 : -1, half_cell = 0.5 * grids_[b].h;
    for (const std::size_t p : near_points_[b]) {
      const double x = bodies_[b].P.x[p], y = bodies_[b].P.y[p], own = 0.5 * std::sqrt(bodies_[b].P.volume[p]);
      each_shared(b, p, [&](Shared& s, double) {
        const double dx = x - s.place.x, dy = y - s.place.y;
        if (std::abs(dx * s.normal.y - dy * s.normal.x) > half_cell) return;
        s.reach[b] = std::max(s.reach[b], sense * (dx * s.normal.x + dy * s.normal.y) + own);
      });
    }
  }
  void push_apart(const Shared& s) {
    if (!(s.reach[0] + s.reach[1] >= 0)) return;
    Pair &a = grids_[0].now[s.node], &b = grids_[1].now[s.node];
    const Pair a_before = grids_[0].old[s.node], b_before = grids_[1].old[s.node];
    const double approach = (a.x - b.x) * s.normal.x + (a.y - b.y) * s.normal.y;
    if (approach <= 0) return;
    const double impulse = approach * s.m[0] * s.m[1] / (s.m[0] + s.m[1]);
    a.x -= impulse / s.m[0] * s.normal.x, a.y -= impulse / s.m[0] * s.normal.y;
    b.x += impulse / s.m[1] * s.normal.x, b.y += impulse / s.m[1] * s.normal.y;
    const Pair middle{a.x + a_before.x - b.x - b_before.x, a.y + a_before.y - b.y - b_before.y};
    lost_ += 0.5 * impulse * (middle.x * s.normal.x + middle.y * s.normal.y);
  }

  std::array<Grid, 2> grids_;
  std::array<Body, 2> bodies_;
  std::vector<int> slot_;   // of each node: its number among the shared ones, or -1
  std::vector<char> near_;  // of each first node of nine: whether a shared one is among them
  std::vector<Shared> shared_;
  std::array<std::vector<std::size_t>, 2> near_points_;
  double lost_ = 0;  // energy that impulses took
};

}  // namespace

int main(int argc, char** argv) {
  const plain::Words words(argc, argv);
  return words.kind == "elastic" ? plain::time_loop<Contact>(words) : 2;
}
