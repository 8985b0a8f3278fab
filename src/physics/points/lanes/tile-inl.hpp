// SPDX-License-Identifier: GPL-3.0-or-later
// Read once for each instruction set, so without #pragma once.
#if defined(TETHER_POINTS_TILE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TETHER_POINTS_TILE_INL
#undef TETHER_POINTS_TILE_INL
#else
#define TETHER_POINTS_TILE_INL
#endif

#include "loops/lanes-inl.hpp"
#include "physics/points/lanes/work.hpp"

HWY_BEFORE_NAMESPACE();
namespace tether::mpm::HWY_NAMESPACE {

using namespace tether::HWY_NAMESPACE;

// A pass takes the points of a group of cells, up to so many layers of eight at a time, through its stages. What a
// stage leaves for the next one stands in a tile, which never leaves the nearest cache.

constexpr std::size_t lanes = Blocks::lanes;
constexpr std::size_t most_layers = 12;

using TileRows = double[most_layers][lanes];

struct alignas(64) Tile {
  TileRows r, s;                       // place in the cell, from its kernel's lowest to highest [cells]
  TileRows m0, m1, m2;                 // mass by the weights along x, 0 of points that leave their cells
  TileRows vx, vy;                     // velocity, by APIC; by FLIP it stands in the points' arrays
  TileRows middle_x, middle_y;         // and that at the cell's own node
  TileRows gxx, gyx, gxy, gyy;         // the field about the point, a difference from node to node [velocity]
  TileRows rate_xx, rate_yy, rate_xy;  // strain rate, as Rates
  TileRows rate_zz, turn;              // and of it the hoop's, and twice the spin
  TileRows pull_xx, pull_xy, pull_yy;  // V sigma [energy]
  TileRows hoop;                       // about an axis: -V sigma_theta / r [force]
  TileRows at_place;                   // a number of the nodes, at the points
  TileRows lost;                       // of the ledger, per mass [velocity^2], then [energy]
  std::size_t slot[most_layers];       // of lane 0
  std::size_t layers;
  std::uint8_t left[most_layers];  // a bit for each lane: the point has left its cell
  bool some_left;                  // of all
  double x0, y0;                   // lane 0's cell along x, the group's along y
};

/// Adds sums over points to rows of the nodes, group after group of a sweep. What cells give to their kernel's nodes
/// along x stands in lanes of cells: a node takes what the cell after it, its own and the one before it give, in this
/// order, and the rows from below. What the last lanes of a group give to the next group's nodes goes along.
template <class D, class Kernel, std::size_t count>
class Putting {
 public:
  static constexpr std::size_t most = count;
  HWY_INLINE explicit Putting(std::ptrdiff_t nx) : nx_(nx) {}

  double* rows[count] = {};
  std::size_t used = count;  // of the rows

  /// A tile of a group whose first cell's node is n.
  HWY_INLINE void begin(std::ptrdiff_t n) {
    if (end_ >= 0 && end_ != n) rest();
    end_ = n + static_cast<std::ptrdiff_t>(lanes);
  }
  /// Where the lines of nodes begin, in rows, to which cells at `sub` give.
  struct Lines {
    std::ptrdiff_t first, nx;
    HWY_INLINE std::ptrdiff_t begin(std::size_t l) const { return first + static_cast<std::ptrdiff_t>(l) * nx; }
  };
  HWY_INLINE Lines lines(std::size_t sub) const { return lines_at(end_ - static_cast<std::ptrdiff_t>(lanes - sub)); }
  /// Adds what cells give to the nodes of line l of the kernel: to the first along x, the second and the third.
  HWY_INLINE void put(std::size_t q, std::size_t l, Lines to, V<D> first, V<D> second, V<D> third) {
    add_to<D>(rows[q] + to.begin(l), (first + one_[q][l].follow(second)) + two_[q][l].follow(third));
  }
  HWY_INLINE void put(std::size_t q, std::size_t l, Lines to, V<D> first, V<D> second) {
    add_to<D>(rows[q] + to.begin(l), first + one_[q][l].follow(second));
  }
  /// Adds what is left of the last cells of a run of groups.
  HWY_INLINE void close() {
    if (end_ >= 0) rest();
    end_ = -1;
  }

 private:
  HWY_INLINE Lines lines_at(std::ptrdiff_t n) const { return {n + Kernel::first * nx_ + Kernel::first, nx_}; }
  HWY_NOINLINE void rest() {
    const V<D> none = hn::Zero(D());
    for (std::size_t q = 0; q < used; ++q) {
      for (std::size_t l = 0; l < Kernel::lines; ++l) {
        if constexpr (Kernel::lines == 2) {
          put(q, l, lines_at(end_), none, none);
        } else {
          put(q, l, lines_at(end_), none, none, none);
          if (width<D> == 1) put(q, l, lines_at(end_ + 1), none, none, none);
        }
      }
    }
  }

  std::ptrdiff_t nx_, end_ = -1;  // node after the last group
  UpBy<D, 1> one_[count][Kernel::lines];
  UpBy<D, 2> two_[count][Kernel::lines];
};

/// Places of points in their cells [cells].
template <class D>
struct Places {
  V<D> r, s;
};

/// Finds places in a tile's cells.
template <class D, class Kernel>
class Locating {
 public:
  HWY_INLINE Locating(const LaneGrid& grid, const Tile& tile, std::size_t sub)
      : x0_(all<D>(grid.x0)),
        y0_(all<D>(grid.y0)),
        per_dx_(all<D>(grid.per_dx)),
        per_dy_(all<D>(grid.per_dy)),
        cell_(counting<D>(tile.x0 + static_cast<double>(sub))),
        row_(all<D>(tile.y0)) {}
  HWY_INLINE Places<D> anywhere(V<D> x, V<D> y) const {
    return {(x - x0_) * per_dx_ - cell_, (y - y0_) * per_dy_ - row_};
  }
  HWY_INLINE Places<D> inside(V<D> x, V<D> y) const {
    const Places<D> at = anywhere(x, y);
    return {Kernel::template inside<D>(at.r), Kernel::template inside<D>(at.s)};
  }

 private:
  V<D> x0_, y0_, per_dx_, per_dy_, cell_, row_;
};

/// Points of a layer: the first one's slot, places, and masses, 0 where there is no point.
template <class D>
struct Layer {
  std::size_t p;
  V<D> x, y, mass;
  Places<D> at;
};
template <class D, class Kernel>
HWY_INLINE Layer<D> layer_of(const LanePoints& P, const Locating<D, Kernel>& locating, std::size_t p) {
  const V<D> x = load<D>(P.x + p), y = load<D>(P.y + p);
  return {p, x, y, load<D>(P.mass + p), locating.inside(x, y)};
}

/// Strain rate of points, the shear twice: d v_x / d y + d v_y / d x; about an axis zz is the hoop's; and twice the
/// spin, d v_x / d y - d v_y / d x [1/time].
template <class D>
struct Rates {
  V<D> xx, yy, xy, zz, turn;
};

template <class D, bool axis>
HWY_INLINE void store_rates(const Rates<D>& of, bool turns, Tile& tile, std::size_t k, std::size_t sub) {
  store<D>(of.xx, tile.rate_xx[k] + sub), store<D>(of.yy, tile.rate_yy[k] + sub);
  store<D>(of.xy, tile.rate_xy[k] + sub);
  if constexpr (axis) store<D>(of.zz, tile.rate_zz[k] + sub);
  if (turns) store<D>(of.turn, tile.turn[k] + sub);
}
template <class D, bool axis>
HWY_INLINE Rates<D> rates_of(const Tile& tile, std::size_t k, std::size_t sub) {
  return {load<D>(tile.rate_xx[k] + sub), load<D>(tile.rate_yy[k] + sub), load<D>(tile.rate_xy[k] + sub),
          axis ? load<D>(tile.rate_zz[k] + sub) : hn::Zero(D()), load<D>(tile.turn[k] + sub)};
}

/// V sigma of points, which pulls at nodes [energy], and about an axis the hoop's -V sigma_theta / r [force].
template <class D>
struct Pull {
  V<D> xx, xy, yy, hoop;
};

template <class D, bool axis>
HWY_INLINE void store_pull(const Pull<D>& of, Tile& tile, std::size_t k, std::size_t sub) {
  store<D>(of.xx, tile.pull_xx[k] + sub), store<D>(of.xy, tile.pull_xy[k] + sub);
  store<D>(of.yy, tile.pull_yy[k] + sub);
  if constexpr (axis) store<D>(of.hoop, tile.hoop[k] + sub);
}

/// Velocities of points and the fields about them, these by the difference that they make from node to node.
template <class D>
struct Motion {
  V<D> vx, vy, gxx, gyx, gxy, gyy;
};
template <class D>
HWY_INLINE void store_motion(const Motion<D>& of, Tile& tile, std::size_t k, std::size_t sub) {
  store<D>(of.vx, tile.vx[k] + sub), store<D>(of.vy, tile.vy[k] + sub);
  store<D>(of.gxx, tile.gxx[k] + sub), store<D>(of.gyx, tile.gyx[k] + sub);
  store<D>(of.gxy, tile.gxy[k] + sub), store<D>(of.gyy, tile.gyy[k] + sub);
}

/// Velocities of a layer.
template <class D>
struct Velocities {
  V<D> x, y;
};
template <class D, bool affine>
HWY_INLINE Velocities<D> velocities_of(const LanePoints& P, const Tile& tile, std::size_t k, std::size_t sub) {
  if constexpr (affine) return {load<D>(tile.vx[k] + sub), load<D>(tile.vy[k] + sub)};
  return {load<D>(P.vx + tile.slot[k] + sub), load<D>(P.vy + tile.slot[k] + sub)};
}

/// Velocities at the nodes, from the group's first one on: of one field, or the mean of two.
struct Field {
  const double *x, *y;
  const double *other_x = nullptr, *other_y = nullptr;
};
/// Its value at a node.
template <class D, bool mean>
HWY_INLINE V<D> at_node(const double* one, const double* other, std::ptrdiff_t n) {
  if constexpr (mean) return all<D>(0.5) * (load<D>(one + n) + load<D>(other + n));
  return load<D>(one + n);
}

/// Rows of mass and momentum, in the order of Putting's.
enum MomentumRow : std::size_t { row_of_x, row_of_y, row_of_m, row_of_gas, row_of_loss };

/// Takes the next layers of a chain of blocks; false where there are none any more.
inline bool next_layers(const Blocks& blocks, std::uint32_t& block, Tile& tile) {
  tile.layers = 0, tile.some_left = false;
  for (; block != Blocks::none && tile.layers < most_layers; block = blocks.next(block)) {
    tile.left[tile.layers] = 0;
    tile.slot[tile.layers++] = block * lanes;
  }
  return tile.layers > 0;
}

}  // namespace tether::mpm::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
