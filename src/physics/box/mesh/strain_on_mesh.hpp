// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "base/team.hpp"
#include "physics/box/mesh/open_faces.hpp"

namespace tether::coupled {

/// The rates of strain of a fluid on a mesh by velocities in the middles of its faces, which make one gradient in each
/// cell (M. Crouzeix, P.-A. Raviart 1973), and by those of the cells. The power that friction takes is
///     2 mu D:D |K|  +  mu beta |K| |v - w|^2  +  mu gamma V |slope of the jump along the face|^2
/// summed over cells and faces. The second part ties a cell's velocity v to its faces (as R. Eymard, T. Gallouet,
/// R. Herbin, IMA J. Numer. Anal. 30 (2010) 1009-1043), but not to their mean: w is the velocity in the middle of the
/// mixed elements that have the faces' fluxes, for it is these that pressures make. The third part is 0 where
/// velocities are linear; without it cells could turn against each other for nothing (P. Hansbo, M. G. Larson, ESAIM
/// M2AN 37 (2003) 63-72).
///
/// Numbers of the faces stand dim a face. Where nothing else holds a face, no stress acts on it.
class StrainOnMesh {
 public:
  /// The mesh must outlive it. `mu` is a viscosity times a time [stress time^2]; `open` is what couples_at() has for
  /// open sides.
  StrainOnMesh(const FlowMesh& mesh, double mu, double density, std::vector<Couple> open);

  /// y = K x for the faces' velocities x [momentum]. Cells take part as they follow the faces: half of x K x is the
  /// least of their energy of motion and of half the power times the time, where they were at rest.
  void find_forces(Team& team, std::span<const double> x, std::span<double> y);
  /// w of a cell.
  Vec<3> velocity(std::size_t cell, std::span<const double> x) const;
  /// Gives the momentum of a cell to its faces, as the transpose.
  void give_faces(std::size_t cell, const Vec<3>& momentum, std::span<double> y) const;
  /// Returns what ties a cell to its faces [mass].
  double tie(std::size_t cell) const { return tie_[cell]; }
  double mass(std::size_t cell) const { return density_ * mesh_.volume[cell]; }
  /// Both in line: the momentum by which a cell of velocity 1 pulls faces that stay at rest.
  double pull(std::size_t cell) const { return mass(cell) * tie_[cell] / (mass(cell) + tie_[cell]); }
  /// Calls f(k, l, K_kl) for the numbers k and l of a cell's faces, K being about what friction makes of them: with
  /// slopes in place of rates of strain and jumps.
  template <class Function>
  void each_of_cell(std::size_t cell, const Function& f) const {
    const auto faces = mesh_.faces_of(cell);
    const std::size_t first = cell * faces.size(), dim = at(mesh_.dim);
    const double by_volume = 1 / mesh_.volume[cell], by_square = pull(cell) * by_volume * by_volume;
    for (std::size_t k = 0; k < faces.size(); ++k) {
      for (std::size_t l = 0; l < faces.size(); ++l) {
        const Vec<3>&of_k = out_[first + k], &of_l = out_[first + l];
        const double slopes = mu_ * by_volume * dot(of_k, of_l),
                     fluxes = by_square * dot(way_[first + k], way_[first + l]);
        for (std::size_t a = 0; a < dim; ++a) {
          for (std::size_t b = 0; b < dim; ++b)
            f(at(faces[k]) * dim + a, at(faces[l]) * dim + b, (a == b ? slopes : 0) + fluxes * of_k[a] * of_l[b]);
        }
      }
    }
  }

 private:
  template <int dim>
  void find(Team& team, std::span<const double> x, std::span<double> y);
  template <int dim>
  Vec<3> velocity_in(std::size_t cell, std::span<const double> x) const;
  template <int dim>
  void find_gradient(std::size_t cell, std::span<const double> x);
  template <int dim>
  void find_stress(std::size_t cell);
  template <int dim>
  void find_force(std::size_t face, std::span<double> y) const;

  const FlowMesh& mesh_;
  double mu_, density_;
  std::vector<Couple> open_;
  std::vector<double> tie_;                // of each cell
  std::vector<double> jump_;               // weight of each face's jump [stress time^2 volume]
  std::vector<double> gradient_, stress_;  // dim x dim of each cell; stress times time [momentum/area]
  std::vector<Vec<3>> out_, way_;          // of each cell's faces: area out of it, and way from its middle to theirs
  std::vector<std::array<int, 2>> place_;  // of each face among those, on both sides; -1: none
  std::vector<Vec<3>> normal_;             // of each face
  std::vector<Vec<3>> pulled_;             // of each cell at rest, by its faces [momentum/volume]
};

}  // namespace tether::coupled
