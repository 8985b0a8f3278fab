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
  TileRows r, s;                                // place in the cell, from its kernel's lowest to highest [cells]
  TileRows m;                                   // mass of points that stay in their cells
  TileRows m0, m1, m2;                          // the same by the weights along x
  TileRows vx, vy;                              // velocity
  TileRows middle_x, middle_y;                  // and that at the cell's own node
  TileRows gxx, gyx, gxy, gyy;                  // the field about the point, a difference from node to node [velocity]
  TileRows xx_by_x, xy_by_x, xy_by_y, yy_by_y;  // -V sigma over a cell's side, by splines over two [force]
  TileRows hoop;                                // about an axis: -V sigma_theta / r [force]
  TileRows at_place;                            // a number of the nodes, at the points
  TileRows lost;                                // of the ledger, per mass [velocity^2], then [energy]
  std::size_t slot[most_layers];                // of lane 0
  std::size_t layers;
  double x0, y0;  // lane 0's cell along x, the group's along y
};

/// Adds sums over points to rows of the nodes, group after group of a sweep. What cells give to their kernel's nodes
/// along x stands in lanes of cells: a node takes what the cell behind it, its own and the one before it give, in this
/// order, and the rows from below. What the last lanes of a group give to the next group's nodes goes along.
template <class D, class Kernel, std::size_t count>
class Putting {
 public:
  HWY_INLINE explicit Putting(std::ptrdiff_t nx) : nx_(nx) {}

  double* rows[count] = {};
  std::size_t used = count;  // of the rows

  /// A tile of a group whose first cell's node is n.
  HWY_INLINE void begin(std::ptrdiff_t n) {
    if (end_ >= 0 && end_ != n) rest();
    end_ = n + static_cast<std::ptrdiff_t>(lanes);
  }
  /// What cells at `sub` give to the nodes of line l of the kernel: to the first along x, the second and the third.
  HWY_INLINE void put(std::size_t q, std::size_t l, std::size_t sub, V<D> first, V<D> second, V<D> third) {
    put_at(q, l, end_ - static_cast<std::ptrdiff_t>(lanes - sub), first, second, third);
  }
  HWY_INLINE void put(std::size_t q, std::size_t l, std::size_t sub, V<D> first, V<D> second) {
    put_at(q, l, end_ - static_cast<std::ptrdiff_t>(lanes - sub), first, second);
  }
  /// What is left of the last cells of a run of groups.
  HWY_INLINE void close() {
    if (end_ >= 0) rest();
    end_ = -1;
  }

 private:
  HWY_INLINE double* at(std::size_t q, std::size_t l, std::ptrdiff_t n) const {
    return rows[q] + n + (static_cast<std::ptrdiff_t>(l) + Kernel::first) * nx_ + Kernel::first;
  }
  HWY_INLINE void put_at(std::size_t q, std::size_t l, std::ptrdiff_t n, V<D> first, V<D> second, V<D> third) {
    Before<D>&own = one_[q][l], &next = two_[q][l];
    add_to<D>(at(q, l, n), (first + up_by_one<D>(second, own)) + up_by_two<D>(third, next));
    own.follow(second), next.follow(third);
  }
  HWY_INLINE void put_at(std::size_t q, std::size_t l, std::ptrdiff_t n, V<D> first, V<D> second) {
    add_to<D>(at(q, l, n), first + up_by_one<D>(second, one_[q][l]));
    one_[q][l].follow(second);
  }
  HWY_NOINLINE void rest() {
    const V<D> none = hn::Zero(D());
    for (std::size_t q = 0; q < used; ++q) {
      for (std::size_t l = 0; l < Kernel::lines; ++l) {
        if constexpr (Kernel::lines == 2) {
          put_at(q, l, end_, none, none);
        } else {
          put_at(q, l, end_, none, none, none);
          if (width<D> == 1) put_at(q, l, end_ + 1, none, none, none);
        }
      }
    }
  }

  std::ptrdiff_t nx_, end_ = -1;  // node after the last group
  Before<D> one_[count][Kernel::lines], two_[count][Kernel::lines];
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

/// Strain rate of points, the shear twice: d v_x / d y + d v_y / d x; about an axis zz is the hoop's [1/time].
template <class D>
struct Rates {
  V<D> xx, yy, xy, zz;
};

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
  tile.layers = 0;
  for (; block != Blocks::none && tile.layers < most_layers; block = blocks.next(block)) {
    tile.slot[tile.layers++] = block * lanes;
  }
  return tile.layers > 0;
}

}  // namespace tether::mpm::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
