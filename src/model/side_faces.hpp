// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "model/coupled.hpp"

namespace tether {

/// A part of a face's area that a jet has.
struct JetShare {
  int jet = 0;      ///< its place among the scene's
  double part = 0;  ///< of the face's area
};

/// A face of the grid in a patch of a side, and how much of its area lies there.
struct FacePart {
  std::size_t face = 0;
  double part = 0;
};

/// The faces, of those across the side's axis, that a patch of a side reaches into, in ascending order.
std::vector<FacePart> faces_of(int side, const AxisBox& patch, const StaggeredGrid& grid);
/// The cell that a face of a side belongs to.
std::size_t cell_at(int side, const StaggeredGrid& grid, std::size_t face);

/// What the faces in the box's sides are, by the parts of their areas, so that what goes through jets and openings is
/// the deck's whatever the grid. Of two jets at one place the later one has it, and a jet has it before an opening. The
/// velocity of a face that has a part of a jet is prescribed: what else of it is open stays closed.
class SideFaces {
 public:
  explicit SideFaces(const Coupled& coupled);

  /// The jets that have a part of a face; none for faces within the box.
  std::span<const JetShare> jets(int axis, std::size_t face) const {
    const int k = number_[static_cast<std::size_t>(axis)][face];
    return k < 0 ? std::span<const JetShare>() : faces_[static_cast<std::size_t>(k)].jets;
  }
  /// How much of a face in a side is open.
  double open(int axis, std::size_t face) const {
    const int k = number_[static_cast<std::size_t>(axis)][face];
    return k < 0 ? 0 : faces_[static_cast<std::size_t>(k)].open;
  }

 private:
  struct Face {
    std::vector<JetShare> jets;
    double open = 0;
  };
  void add_side(const Coupled& coupled, int side);

  std::array<std::vector<int>, 3> number_;  // of each face, -1 within the box
  std::vector<Face> faces_;
};

}  // namespace tether
