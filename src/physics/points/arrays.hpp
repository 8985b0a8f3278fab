// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

#include "fields/rows.hpp"
#include "grid/boxes.hpp"
#include "loops/line_allocator.hpp"
#include "loops/nodes.hpp"
#include "loops/points.hpp"
#include "model/scene.hpp"
#include "physics/points/frame.hpp"
#include "physics/points/lanes/nodes.hpp"
#include "physics/points/node_rows.hpp"

namespace tether::mpm {

/// All material points, an array a property. A point keeps its number (its place in the scene) in `id` while sorting
/// moves it from slot to slot; a body keeps its range of slots. An array is a member and its row, in rows().
struct Points {
  LineArray<double> x, y, vx, vy;
  LineArray<double> vxx, vyx, vxy, vyy;
  LineArray<double> mass, volume;
  LineArray<double> sxx, syy, sxy, szz;
  LineArray<double> rho, energy;
  LineArray<double> strain, hoop, tx, ty;
  LineArray<double> fxx, fxy, fyx, fyy, fzz;
  LineArray<double> dxx, dyy, dxy, dzz;
  LineArray<std::uint8_t> pinned;
  LineArray<int> id;

  /// Name in a checkpoint, array, dimension and meaning of each.
  static constexpr auto rows() {
    using P = Points;
    using D = Dimension;
    using K = Kept;
    return std::tuple{
        ArrayField{"x", &P::x, D::length, "place, x"},
        ArrayField{"y", &P::y, D::length, "place, y"},
        ArrayField{"vx", &P::vx, D::velocity, "velocity, x"},
        ArrayField{"vy", &P::vy, D::velocity, "velocity, y"},
        ArrayField{"vxx", &P::vxx, D::rate, "APIC: the field about the point, d v_x / d x", K::where_asked},
        ArrayField{"vyx", &P::vyx, D::rate, "APIC: d v_y / d x", K::where_asked},
        ArrayField{"vxy", &P::vxy, D::rate, "APIC: d v_x / d y", K::where_asked},
        ArrayField{"vyy", &P::vyy, D::rate, "APIC: d v_y / d y", K::where_asked},
        ArrayField{"mass", &P::mass, D::mass, "mass m_p"},
        ArrayField{"volume", &P::volume, D::volume, "the stored volume V_p; a gas has V_p = m_p / rho instead"},
        ArrayField{"sxx", &P::sxx, D::stress, "stress sigma_p, xx"},
        ArrayField{"syy", &P::syy, D::stress, "stress sigma_p, yy"},
        ArrayField{"sxy", &P::sxy, D::stress, "stress sigma_p, xy"},
        ArrayField{"szz", &P::szz, D::stress,
                   "about an axis and of membranes: the hoop stress; across the plane of laws that carry it",
                   K::where_asked},
        ArrayField{"rho", &P::rho, D::density, "gas: density", K::where_asked},
        ArrayField{"energy", &P::energy, D::specific_energy,
                   "gas: specific internal energy i; viscous linear fluid: its friction's heat", K::where_asked},
        ArrayField{"strain", &P::strain, D::number, "membrane: strain along its tangent, eps_1'", K::where_asked},
        ArrayField{"hoop", &P::hoop, D::number, "membrane about an axis: hoop strain, eps_2'", K::where_asked},
        ArrayField{"tx", &P::tx, D::number, "membrane: unit tangent t, x", K::where_asked},
        ArrayField{"ty", &P::ty, D::number, "membrane: unit tangent t, y", K::where_asked},
        ArrayField{"fxx", &P::fxx, D::number, "deformation gradient F of laws that carry it, d x / d X",
                   K::where_asked},
        ArrayField{"fxy", &P::fxy, D::number, "F, d x / d Y", K::where_asked},
        ArrayField{"fyx", &P::fyx, D::number, "F, d y / d X", K::where_asked},
        ArrayField{"fyy", &P::fyy, D::number, "F, d y / d Y", K::where_asked},
        ArrayField{"fzz", &P::fzz, D::number, "F, the stretch across the plane", K::where_asked},
        // For laws that need their neighbours' new places first.
        ArrayField{"dxx", &P::dxx, D::rate, "strain rate eps', xx", K::within_step},
        ArrayField{"dyy", &P::dyy, D::rate, "strain rate eps', yy", K::within_step},
        ArrayField{"dxy", &P::dxy, D::rate, "strain rate eps', xy", K::within_step},
        ArrayField{"dzz", &P::dzz, D::rate, "strain rate eps', about an axis its hoop's", K::within_step},
        ArrayField{"pinned", &P::pinned, D::number, "1 where the point is held at its place"},
        ArrayField{"id", &P::id, D::number, "number of the point in the scene, from 0; -1 of a slot without a point"},
    };
  }

  /// Takes the points of the scene, with the arrays that its laws and its method ask for. `given` is empty then: each
  /// of its arrays goes once it has been read, for both do not fit in the memory of a large run.
  Points(const Scene& scene, PointSet& given);
  /// Slots, of which not all need hold a point.
  std::size_t size() const { return x.size(); }
  bool holds(std::size_t p) const { return id[p] >= 0; }
  /// The point's velocity is that of all about it.
  void forget_field(std::size_t p) {
    if (!vxx.empty()) vxx[p] = vyx[p] = vxy[p] = vyy[p] = 0;
  }
  /// A number of an array that may not be there: 0 then.
  double at(LineArray<double> Points::*array, std::size_t p) const {
    return (this->*array).empty() ? 0 : (this->*array)[p];
  }

  /// Calls visit(array) for each property that the scene's points have.
  template <class Visit>
  void each_array(const Visit& visit) {
    each_row(rows(), [&](const auto& row) {
      if (row.carried_by(*this)) visit(this->*row.array);
    });
  }
};
/// Adds what points gave to ghosts to their images; the ghosts are empty then.
void fold_sums(std::span<const Ghost> ghosts, NodeSumsRow& sums);

/// The background grid's fields. By splines a "cell" is what lies nearest to a node. What ghosts hold is folded at
/// once.
struct Grid {
  Frame frame;
  NodeSumsRow sums;
  NodeMotionRow motion;
  PairRow convected;  // (3.24): first sum m v N, then divided by m; by usf the velocity before the solve
  NodeGasRow gas;     // where the gas takes its density from the nodes
  NodeRow loss;       // where the ledger is kept: energy that the gas takes in the next step [energy]
  NodeRow squares;    // where the ledger is kept: |v|^2 before the solve plus after it
  ActiveNodes active;
  std::vector<Ghost> ghosts;  // those that points reach, now or after a step of a cell
  NodePasses passes;

  Grid(const Scene& scene, InstructionSet set);

  /// Lists the frame's ghosts, after the nodes that points may touch were listed.
  void list_ghosts();

  // Adds what points gave to ghosts to their images; the ghosts are empty then.
  void fold_sums() { mpm::fold_sums(ghosts, sums); }
  void fold_convected();
  // What points read at ghosts.
  void unfold_motion();
  void unfold_convected();
  void fold_loss();
  void unfold_gas();
  void unfold_squares();
};

/// Sorts the slots of bodies by cell, then by point number: neighbours in space become neighbours in memory, and the
/// order does not depend on what it was before. All that a point remembers moves with it. Keeps its work space between
/// calls.
class CellSort {
 public:
  /// What a point is sorted by, and its slot before.
  struct Key {
    int cell, id;
    std::size_t slot;
  };
  void operator()(Points& points, Range range, const BackgroundGrid& shape);

 private:
  template <class Number>
  void permute(LineArray<Number>& array, Range range);

  std::vector<Key> keys_;
  std::tuple<LineArray<double>, LineArray<int>, LineArray<std::uint8_t>> scratch_;  // one for each type of array
};

}  // namespace tether::mpm
