// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/film_pressures.hpp"

#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>

#include "algebra/small_factors.hpp"
#include "base/blocks.hpp"
#include "base/numbers.hpp"
#include "grid/crossings.hpp"

namespace tether::coupled {
namespace {

constexpr std::size_t rims_of_a_block = 8;
constexpr double contact_gap = 1e-6;  // of a cell: surfaces that are nearer to each other touch

double length(const Vec<3>& a) { return std::sqrt(dot(a, a)); }

/// Less its part along a normal of length 1.
Vec<3> along_plane(const Vec<3>& a, const Vec<3>& normal) {
  const double across = dot(a, normal);
  return {a[0] - across * normal[0], a[1] - across * normal[1], a[2] - across * normal[2]};
}

Vec<3> unit(const Vec<3>& a) {
  const double size = length(a);
  return size > 0 ? Vec<3>{a[0] / size, a[1] / size, a[2] / size} : Vec<3>{};
}

}  // namespace

FilmPressures::FilmPressures(Team& team, const FilmsOf& of) : of_(of), kind_(of.before.size(), Kind::rim) {
  if (std::all_of(of.before.begin(), of.before.end(), [](int cell) { return cell >= 0; })) return;
  for (std::size_t k = 0; k < kind_.size(); ++k) kind_[k] = kind_of(k);
  list_sides_of_nodes();
  number_films();
  link_films();
  share_rims(team);
}

FilmPressures::Kind FilmPressures::kind_of(std::size_t piece) const {
  if (of_.open_side[piece] >= 0) return Kind::outlet;
  if (of_.before[piece] >= 0) return Kind::rim;
  const SurfacePiece& of = of_.pieces.pieces[piece];
  const StaggeredGrid& grid = of_.domain.grid;
  Kind kind = Kind::film;
  for (int axis = 0; axis < grid.dim; ++axis) {
    const double x = of.middle[at(axis)], edge = contact_gap * grid.d[at(axis)];
    const bool below = x < grid.low[at(axis)] - edge;
    if (!below && x <= grid.high(axis) + edge) continue;
    if (lets_out(axis, below ? 0 : 1)) return Kind::outlet;
    kind = Kind::none;
  }
  return kind == Kind::film && is_in_another_solid(of) ? Kind::none : kind;
}

/// Returns whether a side of the box is open; where solids cover all of it, it is not.
bool FilmPressures::lets_out(int axis, int end) const {
  const StaggeredGrid& grid = of_.domain.grid;
  const auto& faces = of_.domain.face[at(axis)];
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (grid.place_of_face(axis, f)[at(axis)] == end * grid.n[at(axis)] && faces[f] == FaceKind::open) return true;
  }
  return false;
}

/// Looks at the place just inside of the piece, so that bodies which touch are not in each other.
bool FilmPressures::is_in_another_solid(const SurfacePiece& piece) const {
  const int part = of_.surface.part[at(piece.side)];
  if (of_.surface.parts < 2) return false;
  const Vec<3> normal = unit(of_.pieces.area[at(piece.side)]);
  Vec<3> x = piece.middle;
  for (std::size_t i = 0; i < at(of_.surface.dim); ++i) x[i] -= contact_gap * of_.domain.grid.d[i] * normal[i];
  return turns_about(of_.surface, of_.q, x, part) > 0.5;
}

void FilmPressures::list_sides_of_nodes() {
  first_.assign(of_.surface.side_count() + 1, 0);
  for (const SurfacePiece& piece : of_.pieces.pieces) ++first_[at(piece.side) + 1];
  for (std::size_t s = 0; s + 1 < first_.size(); ++s) first_[s + 1] += first_[s];
  sides_.resize(of_.q.size() / at(of_.surface.dim));
  for (std::size_t s = 0; s < of_.surface.side_count(); ++s) {
    for (const int node : of_.surface.side(s)) sides_[at(node)].push_back(static_cast<int>(s));
  }
}

/// In the plane: the piece at a node's end of each other side that has the node.
void FilmPressures::add_ends(int side, int node, std::vector<int>& found) const {
  for (const int other : sides_[at(node)]) {
    if (other == side || first_[at(other)] == first_[at(other) + 1]) continue;
    found.push_back(of_.surface.side(at(other))[0] == node ? first_[at(other)] : first_[at(other) + 1] - 1);
  }
}

/// In space: the pieces of a side in the same cell or those around it.
void FilmPressures::add_near(std::size_t piece, int side, std::vector<int>& found) const {
  const auto& cell = of_.pieces.pieces[piece].cell;
  for (int k = first_[at(side)]; k < first_[at(side) + 1]; ++k) {
    const auto& other = of_.pieces.pieces[at(k)].cell;
    bool near = at(k) != piece;
    for (std::size_t i = 0; i < 3; ++i) near = near && std::abs(cell[i] - other[i]) <= 1;
    if (near) found.push_back(k);
  }
}

/// The pieces that the surface goes on with.
std::vector<int> FilmPressures::touching(std::size_t piece) const {
  const int side = of_.pieces.pieces[piece].side, k = static_cast<int>(piece);
  const auto nodes = of_.surface.side(at(side));
  std::vector<int> found;
  if (of_.surface.dim == 2) {
    k > first_[at(side)] ? found.push_back(k - 1) : add_ends(side, nodes[0], found);
    k + 1 < first_[at(side) + 1] ? found.push_back(k + 1) : add_ends(side, nodes[1], found);
    return found;
  }
  std::map<int, int> shared;  // of each side about this one how many nodes
  for (const int node : nodes) {
    for (const int other : sides_[at(node)]) ++shared[other];
  }
  for (const auto& [other, count] : shared) {
    if (count > 1) add_near(piece, other, found);
  }
  return found;
}

/// A film that is joined with no rim has no pressure that could be known. One between two regions of the fluid is a
/// seal: the solid shuts them off from each other, so nothing gets in there.
void FilmPressures::number_films() {
  number_.assign(kind_.size(), -1);
  for (std::size_t k = 0; k < kind_.size(); ++k) {
    if (kind_[k] != Kind::film || number_[k] >= 0) continue;
    const std::size_t first = films_.size();
    if (number_whole(static_cast<int>(k))) continue;
    for (std::size_t n = first; n < films_.size(); ++n) kind_[at(films_[n])] = Kind::none, number_[at(films_[n])] = -1;
    films_.resize(first);
  }
}

/// All pieces of the film that has this one; whether it has rims of one region.
bool FilmPressures::number_whole(int piece) {
  bool has_rims = false;
  std::set<int> regions;
  const auto take = [&](int other) {
    if (kind_[at(other)] == Kind::rim || kind_[at(other)] == Kind::outlet) has_rims = true;
    if (kind_[at(other)] == Kind::rim) regions.insert(of_.domain.region[at(of_.before[at(other)])]);
    if (kind_[at(other)] != Kind::film || number_[at(other)] >= 0) return;
    number_[at(other)] = static_cast<int>(films_.size());
    films_.push_back(other);
  };
  std::size_t next = films_.size();
  take(piece);
  for (; next < films_.size(); ++next) {
    for (const int other : touching(at(films_[next]))) take(other);
  }
  regions.erase(-1);  // void
  return has_rims && regions.size() <= 1;
}

void FilmPressures::link_films() {
  for (const int film : films_) {
    for (const int other : touching(at(film))) {
      if (kind_[at(other)] != Kind::none) links_.push_back({film, other, conductance(at(film), at(other))});
    }
  }
}

/// To a rim by the way along the film's own plane: the rim may be round a corner.
double FilmPressures::conductance(std::size_t film, std::size_t other) const {
  const SurfacePiece &a = of_.pieces.pieces[film], &b = of_.pieces.pieces[other];
  const Vec<3> way = minus(b.middle, a.middle);
  const double least = contact_gap * *std::min_element(of_.domain.grid.d.begin(), of_.domain.grid.d.end());
  const double far =
      kind_[other] == Kind::film ? length(way) : length(along_plane(way, unit(of_.pieces.area[at(a.side)])));
  return 1 / std::max(far, least);
}

/// Finds what the pressure of each rim, or of an outlet, is to each piece of the films: for each of them one solution
/// of Laplace's equation.
void FilmPressures::share_rims(Team& team) {
  for (const Link& link : links_) {
    if (kind_[at(link.other)] != Kind::film) rims_.push_back(link.other);
  }
  std::sort(rims_.begin(), rims_.end());
  rims_.erase(std::unique(rims_.begin(), rims_.end()), rims_.end());
  if (films_.empty()) return;
  SmallFactors factors;
  factors.factorise(laplacian());
  shares_.resize(std::ssize(rims_), std::ssize(films_));
  each_block(
      team, rims_.size(),
      [&](std::size_t begin, std::size_t end) {
        const auto first = static_cast<Eigen::Index>(begin), count = static_cast<Eigen::Index>(end - begin);
        Eigen::MatrixXd parts = Eigen::MatrixXd::Zero(std::ssize(films_), count);
        for (const Link& link : links_) {
          const auto rim = std::lower_bound(rims_.begin(), rims_.end(), link.other) - rims_.begin() - first;
          if (kind_[at(link.other)] != Kind::film && rim >= 0 && rim < count)
            parts(number_[at(link.film)], rim) += link.conductance;
        }
        shares_.middleRows(first, count) = factors.solve(parts).transpose();
      },
      rims_of_a_block);
}

/// Makes the Laplacian of the films' pieces, by numbers.
Eigen::SparseMatrix<double> FilmPressures::laplacian() const {
  std::vector<Eigen::Triplet<double>> entries;
  for (const Link& link : links_) {
    const int row = number_[at(link.film)];
    entries.emplace_back(row, row, link.conductance);
    if (kind_[at(link.other)] == Kind::film) entries.emplace_back(row, number_[at(link.other)], -link.conductance);
  }
  Eigen::SparseMatrix<double> laplace(std::ssize(films_), std::ssize(films_));
  laplace.setFromTriplets(entries.begin(), entries.end());
  return laplace;
}

/// Each rim's pressure is taken where the rim is along the film, and where the piece is across it.
std::vector<std::pair<std::size_t, double>> FilmPressures::on(std::size_t piece) const {
  std::vector<std::pair<std::size_t, double>> sum;
  if (number_.empty() || number_[piece] < 0) return sum;
  const SurfacePiece& film = of_.pieces.pieces[piece];
  const Vec<3> normal = unit(of_.pieces.area[at(film.side)]);
  std::map<std::size_t, double> weight;
  for_shares(number_[piece], [&](std::size_t rim, double part) {
    if (kind_[rim] == Kind::outlet) return;
    const Vec<3> along = along_plane(minus(of_.pieces.pieces[rim].middle, film.middle), normal);
    const Vec<3> x{film.middle[0] + along[0], film.middle[1] + along[1], film.middle[2] + along[2]};
    const PressureStencil stencil = of_.sampler.at(x, at(of_.before[rim]), 1);
    for (std::size_t s = 0; s < stencil.size; ++s) weight[stencil.cell[s]] += part * stencil.weight[s];
  });
  sum.assign(weight.begin(), weight.end());
  return sum;
}

}  // namespace tether::coupled
