// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/warned.hpp"
#include "fields/rows.hpp"
#include "loops/points.hpp"
#include "model/method.hpp"
#include "model/scene.hpp"
#include "physics/points/arrays.hpp"
#include "physics/points/point_laws.hpp"

namespace tether::mpm {

/// Gas on one side of an edge. `across` counts into the grid, `along` the edge's axis.
struct EdgeGas {
  double density = 0, across = 0, along = 0, pressure = 0;  // [mass/volume], [velocity], [stress]
};

/// The gas at an edge between what is outside and what is inside: the solution, on the edge, of the Riemann problem of
/// the two. For weak waves that is the theory of characteristics: what a subsonic inflow takes from the inside is the
/// wave that runs out, p - rho c u, and all else from outside; a supersonic one takes all from outside; a subsonic
/// outflow takes from outside the wave that runs in, p + rho c u, and all else from the inside; a supersonic one takes
/// nothing from outside. An outflow with nothing said of the outside has there what is inside: no wave runs in.
EdgeGas gas_on_edge(const Edge& edge, const EdgeGas& outside, const EdgeGas& inside, double gamma);

/// The points, and the slots of each body: what strips change.
struct BodyPoints {
  Points& points;
  std::vector<Slots>& ranges;
};

/// What strips found in a step, and whether points came or went, so that bodies stand in other slots.
struct EdgeFindings {
  StepFindings found;
  bool regrouped = false;
};

/// What has passed through all edges since the start. Momentum and energy count into the grid; energy is that of the
/// points that passed, and what the gas of the strips gave to the nodes or took from them.
struct Passed {
  double mass_in = 0, mass_out = 0;       // [mass]
  double momentum_x = 0, momentum_y = 0;  // [momentum]
  double energy_in = 0, energy_out = 0;   // [energy]
  double stored = 0;                      // internal energy, a part of these: what came in less what went out [energy]
  double back = 0;                        // mass that came in at an outflow or left by an inflow [mass]

  /// Name in a checkpoint, and member.
  static constexpr auto rows() {
    using P = Passed;
    return std::tuple{NumberField{"edge_mass_in", &P::mass_in},       NumberField{"edge_mass_out", &P::mass_out},
                      NumberField{"edge_momentum_x", &P::momentum_x}, NumberField{"edge_momentum_y", &P::momentum_y},
                      NumberField{"edge_energy_in", &P::energy_in},   NumberField{"edge_energy_out", &P::energy_out},
                      NumberField{"edge_stored", &P::stored},         NumberField{"edge_back", &P::back}};
  }
};
/// The strips of gas beyond open edges. Their points are real ones, so that nodes at the edge have whole masses and
/// pressures, but they are a reservoir: after each step they stand where the velocity on the edge carried them, with
/// that velocity and with the energy that makes the pressure on the edge. What crosses the edge inward becomes free,
/// what crosses it outward becomes the strip's. Points are removed at the far end and, as the strip moves inward, made
/// there at the lattice spacing.
class Strips {
 public:
  Strips(const Scene& scene, const Points& points);
  bool on() const { return on_; }

  /// Fills the strips at the start, before densities and energies are found; then gives them the gas on the edge, and
  /// returns its waves. Bodies stand in other slots than before fill().
  void fill(const BodyPoints& bodies, const Scene& scene);
  StepFindings begin(const BodyPoints& bodies, const Scene& scene);

  /// Notes what the strips' points have before a step.
  void before_step(const Points& points, const std::vector<Slots>& ranges, const Scene& scene);
  /// At `time`, after a step of dt: books what passed, carries the strips on, removes and makes points. Sums at the
  /// nodes have to be mapped anew. Trouble where anything but gas stands beyond an edge.
  EdgeFindings after_step(const BodyPoints& bodies, const Scene& scene, double dt, double time);

  /// Returns whether a place lies beyond an open edge.
  bool holds(double x, double y) const { return edge_of(x, y) != inside_; }
  const Passed& passed() const { return passed_; }
  /// Heat under way at nodes that no point reaches any more left with the gas that was there.
  void book_lost_heat(double energy) { passed_.energy_out += energy, passed_.stored -= energy; }
  std::vector<std::string> take_news();
  /// Numbers for points to come.
  int next_id() const { return next_id_; }

  /// The list of what a restart needs, for both ways.
  template <class Exchange, class AnyStrips>
  static void exchange(Exchange& with, AnyStrips& strips);
  /// After a restart.
  void find_gas_on_edges();

 private:
  static constexpr int inside_ = -1;
  static constexpr int corner_ = 4;  // and edge number: a corner block, whose points stay where they are

  /// Cells along an edge, with the gas before it as it was last seen, and on it.
  struct Cells {
    std::vector<int> body;  // of the gas inside, or none
    std::vector<double> density, across, along, pressure;
    std::vector<EdgeGas> on_edge;
  };
  /// Lines of points into a strip at the lattice's places along the edge.
  struct Rows {
    std::vector<double> place;  // along the edge [length]
    std::vector<int> cell, lattice;
    std::vector<double> tail;  // distance inward of the last place of the lattice, negative [length]
  };
  /// A point of a strip before a step.
  struct Note {
    std::size_t slot = 0;
    int edge = 0;
    bool keeps_density = false;  // which continuity would spoil at the strip's far end
    double x = 0, y = 0, vx = 0, vy = 0, rho = 0, energy = 0;
    double total = 0;  // its energy of all kinds [energy]
  };

  bool low(std::size_t k) const { return k % 2 == 0; }
  double line(std::size_t k) const;
  double cell_across(std::size_t k) const { return k < 2 ? grid_.dx : grid_.dy; }
  double cell_along(std::size_t k) const { return k < 2 ? grid_.dy : grid_.dx; }
  double first_along(std::size_t k) const { return k < 2 ? grid_.y0 : grid_.x0; }
  int cells_along(std::size_t k) const { return k < 2 ? grid_.cells_y() : grid_.cells_x(); }
  double inward(std::size_t k, double x, double y) const {
    const double distance = (k < 2 ? x : y) - line(k);
    return low(k) ? distance : -distance;
  }
  int edge_of(double x, double y) const;
  std::size_t cell_of(std::size_t k, double along) const;
  EdgeGas outside(std::size_t k, const EdgeGas& inside) const;
  EdgeGas on_edge(std::size_t k, double along) const;
  double total_energy(const Points& points, std::size_t p, const Scene& scene) const;

  void find_bodies_at(std::size_t k, const BodyPoints& bodies, const Scene& scene);
  void lay_rows(std::size_t k, const Scene& scene);
  void fill_row(std::size_t k, std::size_t row, const BodyPoints& bodies, const Scene& scene);
  void fill_corners(std::size_t k, const BodyPoints& bodies, const Scene& scene);
  void make(const BodyPoints& bodies, const Scene& scene, std::size_t body, double x, double y, double density,
            double area);

  void return_to_reservoir(const BodyPoints& bodies, const Scene& scene, double dt);
  Trouble let_pass(const BodyPoints& bodies, const Scene& scene);
  void enter(std::size_t k, const Points& points, const Scene& scene, std::size_t p);
  void leave(std::size_t k, const Points& points, const Scene& scene, std::size_t p);
  void tell_wrong_way(std::size_t k, const Points& points, std::size_t p);
  void feed(std::size_t k, const BodyPoints& bodies, const Scene& scene, double dt);
  void regroup(const BodyPoints& bodies, const Scene& scene);
  void look_inside(const BodyPoints& bodies, const Scene& scene);
  StepFindings set_strips(const BodyPoints& bodies, const Scene& scene) const;
  void book_energy();

  bool on_ = false;
  BackgroundGrid grid_;
  Geometry geometry_;
  Pair D_{};  // of APIC's fields, h^2/4 an axis [length2]
  Edges edges_;
  double gm1_ = 0;
  std::array<Cells, 4> cells_;
  std::array<Rows, 4> rows_;
  Passed passed_;
  int next_id_ = 0;
  long long warned_ = 0;  // of edges through which gas goes the wrong way
  std::vector<std::string> news_;
  double time_ = 0;  // at the end of the step, for the news [time]

  std::array<double, 4> energy_of_step_{};  // that came in by each edge [energy]
  std::vector<Note> notes_;
  std::vector<char> noted_, gone_;  // of each slot
  std::vector<int> made_;           // body of each point made, which stand after all others
  std::vector<std::size_t> order_;  // scratch of regroup()
  std::vector<double> doubles_;
  struct Sums {
    double mass = 0, volume = 0, energy = 0, px = 0, py = 0, largest = 0, own = 0;
  };
  std::vector<Sums> sums_;  // over the gas before each cell, scratch of look_inside()
};

template <class Exchange, class AnyStrips>
void Strips::exchange(Exchange& with, AnyStrips& strips) {
  if (!strips.on_) return;
  constexpr std::array names{
      std::array{"left_body", "left_density", "left_across", "left_along", "left_pressure", "left_tail"},
      std::array{"right_body", "right_density", "right_across", "right_along", "right_pressure", "right_tail"},
      std::array{"bottom_body", "bottom_density", "bottom_across", "bottom_along", "bottom_pressure", "bottom_tail"},
      std::array{"top_body", "top_density", "top_across", "top_along", "top_pressure", "top_tail"}};
  for (std::size_t k = 0; k < 4; ++k) {
    auto& cells = strips.cells_[k];
    with(names[k][0], cells.body), with(names[k][1], cells.density), with(names[k][2], cells.across);
    with(names[k][3], cells.along), with(names[k][4], cells.pressure), with(names[k][5], strips.rows_[k].tail);
  }
  exchange_numbers(with, strips.passed_);
  with("next_id", strips.next_id_);
  with("edges_warned", strips.warned_);
}

}  // namespace tether::mpm
