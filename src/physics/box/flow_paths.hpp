// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/vec.hpp"
#include "physics/box/outside.hpp"

namespace tether::coupled {

/// How each cell is joined to those beside it: bit 2 a + side says that the face on its lower (0) or upper (1) side
/// across axis a is open and leads to another cell of the box; the same bit 6 further up that a solid closes it. Where
/// a cell is joined to all of them, `room` is how many layers of such cells lie all around it, 254 at most.
class CellJoins {
 public:
  explicit CellJoins(const FlowDomain& domain);

  bool joined(std::size_t cell, int side) const { return bits_[cell] >> side & 1; }
  bool closed(std::size_t cell, int side) const { return bits_[cell] >> (side + 6) & 1; }
  int room(std::size_t cell) const { return room_[cell]; }

 private:
  std::vector<std::uint16_t> bits_;
  std::vector<std::uint8_t> room_;
};

/// Where something is: a cell, and how far it is between the cell's lower and upper sides, from 0 to 1 on each axis.
struct FlowPlace {
  std::array<int, 3> cell{};
  Vec<3> at{};
};

/// A velocity found between faces: by those that can be reached, which are `whole` where no solid comes between; it
/// lies between `low` and `high`.
struct FlowValue {
  double value = 0, low = 0, high = 0;
  bool whole = true;
};

/// Paths through the fluid that never go through a solid or a wall, and values between the faces beside a place.
///
/// A component across axis a is linear between the two faces of the place's cell, and between this cell and those next
/// to it on the place's side; a cell that cannot be reached from the place's within these through open faces does not
/// count, and of two faces of a cell neither does one that a solid closes. Beside walls this is a constant extension.
template <int dim>
class FlowPaths {
 public:
  explicit FlowPaths(const FlowDomain& domain) : grid_(domain.grid), joins_(domain) {
    for (std::size_t a = 0; a < dim; ++a) {
      const auto m = grid_.faces(static_cast<int>(a));
      stride_[a] = {1, m[0], m[0] * m[1]};
    }
  }

  const CellJoins& joins() const { return joins_; }

  /// The middle of a face, as a place of its upper cell, or of the last one in the box.
  FlowPlace middle_of_face(int axis, const std::array<int, 3>& face) const {
    const auto a = static_cast<std::size_t>(axis);
    FlowPlace place{face, {0.5, 0.5, 0.5}};
    place.at[a] = 0;
    if (face[a] == grid_.n[a]) --place.cell[a], place.at[a] = 1;
    return place;
  }

  /// Goes on by `way` [cells], cell by cell. What would leave the box goes on along its side; at any other face that is
  /// not open the path ends. False where it was cut short so.
  bool follow(FlowPlace& place, Vec<dim> way) const {
    if (nothing_beside(place, way)) return go(place, way);
    bool uncut = true;
    for (double left = 1;;) {
      std::size_t axis = dim;
      double next = left;
      for (std::size_t b = 0; b < dim; ++b) {
        if (way[b] == 0) continue;
        const double t = ((way[b] > 0 ? 1.0 : 0.0) - place.at[b]) / way[b];
        if (t < next) next = t, axis = b;
      }
      for (std::size_t b = 0; b < dim; ++b) place.at[b] = std::clamp(place.at[b] + way[b] * next, 0.0, 1.0);
      if (axis == dim) return uncut;
      const Crossing crossing = cross(place, axis, way);
      if (crossing == Crossing::barred) return false;
      uncut = uncut && crossing == Crossing::through;
      left -= next;
    }
  }

  /// All components at a place.
  Vec<dim> velocity(const FaceValues& v, const FlowPlace& place) const {
    Vec<dim> u;
    for (int a = 0; a < dim; ++a) u[static_cast<std::size_t>(a)] = component(v, a, place);
    return u;
  }

  double component(const FaceValues& v, int axis, const FlowPlace& place) const {
    const Rows r = rows_beside(axis, place);
    if (joins_.room(grid_.cell(place.cell)) == 0) return between_reached(v, axis, place, r).value;
    const auto a = static_cast<std::size_t>(axis);
    const double t = place.at[a];
    double sum = 0;
    for (std::size_t i = 0; i < rows; ++i) {
      const double* lower = v[a].data() + r.first[i];
      sum += r.weight[i] * ((1 - t) * lower[0] + t * lower[stride_[a][a]]);
    }
    return sum;
  }

  FlowValue value(const FaceValues& v, int axis, const FlowPlace& place) const {
    const Rows r = rows_beside(axis, place);
    return joins_.room(grid_.cell(place.cell)) > 0 ? between_all(v, axis, place, r)
                                                   : between_reached(v, axis, place, r);
  }

 private:
  static constexpr std::size_t rows = std::size_t{1} << (dim - 1);  // of two faces of a cell
  struct Rows {
    std::array<std::ptrdiff_t, rows> first;  // lower face of each, that of the place's own cell first
    std::array<double, rows> weight;
  };

  // Whether all cells in reach are joined.
  bool nothing_beside(const FlowPlace& place, const Vec<dim>& way) const {
    const int room = joins_.room(grid_.cell(place.cell));
    bool within = room > 0;
    for (const double cells : way) within = within && std::abs(cells) <= room;  // a number that is none is not
    return within;
  }

  static bool go(FlowPlace& place, const Vec<dim>& way) {
    constexpr int below = 256;  // more than there is room for: so that numbers are cut off downwards
    for (std::size_t b = 0; b < dim; ++b) {
      const double to = place.at[b] + way[b];
      const int cells = static_cast<int>(to + below) - below;
      place.cell[b] += cells, place.at[b] = std::max(to - cells, 0.0);
    }
    return true;
  }

  enum class Crossing { through, side_of_box, barred };

  // Crosses the face in the way if it can; else takes its axis out of the way.
  Crossing cross(FlowPlace& place, std::size_t axis, Vec<dim>& way) const {
    const bool up = way[axis] > 0;
    place.at[axis] = up ? 1 : 0;
    if (joins_.joined(grid_.cell(place.cell), static_cast<int>(2 * axis) + up)) {
      place.cell[axis] += up ? 1 : -1;
      place.at[axis] = up ? 0 : 1;
      return Crossing::through;
    }
    way[axis] = 0;
    return place.cell[axis] == (up ? grid_.n[axis] - 1 : 0) ? Crossing::side_of_box : Crossing::barred;
  }

  Rows rows_beside(int axis, const FlowPlace& place) const {
    Rows r;
    const auto a = static_cast<std::size_t>(axis);
    r.first[0] = static_cast<std::ptrdiff_t>(grid_.face(axis, place.cell)), r.weight[0] = 1;
    std::size_t count = 1;
    for (std::size_t b = 0; b < dim; ++b) {
      if (b == a) continue;
      const bool up = place.at[b] >= 0.5;
      const double w = up ? place.at[b] - 0.5 : 0.5 - place.at[b];
      for (std::size_t i = 0; i < count; ++i) {
        r.first[i + count] = r.first[i] + (up ? stride_[a][b] : -stride_[a][b]);
        r.weight[i + count] = r.weight[i] * w;
        r.weight[i] *= 1 - w;
      }
      count *= 2;
    }
    return r;
  }

  FlowValue between_all(const FaceValues& v, int axis, const FlowPlace& place, const Rows& r) const {
    const auto a = static_cast<std::size_t>(axis);
    const double* f = v[a].data();
    const double t = place.at[a];
    FlowValue found{0, f[r.first[0]], f[r.first[0]], true};
    for (std::size_t i = 0; i < rows; ++i) {
      const double lower = f[r.first[i]], upper = f[r.first[i] + stride_[a][a]];
      found.value += r.weight[i] * ((1 - t) * lower + t * upper);
      found.low = std::min({found.low, lower, upper});
      found.high = std::max({found.high, lower, upper});
    }
    return found;
  }

  [[gnu::noinline]] FlowValue between_reached(const FaceValues& v, int axis, const FlowPlace& place,
                                              const Rows& r) const {
    const auto a = static_cast<std::size_t>(axis);
    std::array<std::size_t, rows> cell{};
    FlowValue found;
    const std::array<bool, rows> reached = reached_rows(axis, place, cell, found.whole);
    double sum = 0, weights = 0;
    bool first = true;
    for (std::size_t i = 0; i < rows; ++i) {
      if (!reached[i]) continue;
      double lower = v[a][static_cast<std::size_t>(r.first[i])],
             upper = v[a][static_cast<std::size_t>(r.first[i] + stride_[a][a])];
      const bool no_lower = joins_.closed(cell[i], 2 * axis), no_upper = joins_.closed(cell[i], 2 * axis + 1);
      if (no_lower || no_upper) found.whole = false;
      if (no_lower && no_upper && i > 0) continue;  // of the own cell there are at least extended ones
      if (no_lower && !no_upper) lower = upper;
      if (no_upper && !no_lower) upper = lower;
      sum += r.weight[i] * ((1 - place.at[a]) * lower + place.at[a] * upper);
      weights += r.weight[i];
      found.low = first ? std::min(lower, upper) : std::min({found.low, lower, upper});
      found.high = first ? std::max(lower, upper) : std::max({found.high, lower, upper});
      first = false;
    }
    found.value = sum / weights;
    return found;
  }

  // Which rows' cells can be reached, with their numbers; whether no solid comes between any.
  std::array<bool, rows> reached_rows(int axis, const FlowPlace& place, std::array<std::size_t, rows>& cell,
                                      bool& whole) const {
    std::array<bool, rows> reached{true};
    cell[0] = grid_.cell(place.cell);
    std::array<int, 2> side{};
    for (int b = 0, row = 1; b < dim; ++b) {
      if (b == axis) continue;
      const auto i = static_cast<std::size_t>(row++);
      side[i - 1] = 2 * b + (place.at[static_cast<std::size_t>(b)] >= 0.5);
      reached[i] = step(place.cell, cell[0], side[i - 1], cell[i], whole);
    }
    if constexpr (dim == 3) {
      for (const std::size_t i : {std::size_t{1}, std::size_t{2}}) {
        if (reached[i] && step(grid_.place_of_cell(cell[i]), cell[i], side[2 - i], cell[3], whole)) reached[3] = true;
      }
    }
    return reached;
  }

  // The next cell on a side, if it is joined to this one.
  bool step(std::array<int, 3> place, std::size_t cell, int side, std::size_t& next, bool& whole) const {
    if (joins_.closed(cell, side)) whole = false;
    if (!joins_.joined(cell, side)) return false;
    place[static_cast<std::size_t>(side / 2)] += side % 2 == 1 ? 1 : -1;
    next = grid_.cell(place);
    return true;
  }

  const StaggeredGrid& grid_;
  CellJoins joins_;
  std::array<std::array<std::ptrdiff_t, 3>, 3> stride_{};
};

}  // namespace tether::coupled
