// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/friction/strain_rates.hpp"

#include <algorithm>

namespace tether::coupled {
namespace {

constexpr std::array<int, 3> all_of_it{-1, -1, -1};
constexpr std::size_t places_of_a_block = 512;  // of a liquid few are needed

template <class Function>
void each_place(const std::array<int, 3>& size, const Function& f) {
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      for (int i = 0; i < size[0]; ++i) f(std::array<int, 3>{i, j, k});
    }
  }
}

}  // namespace

double mean_part(const CellParts& parts, int dim, std::size_t cell, const std::array<int, 3>& half) {
  if (parts.empty()) return 1;
  const std::size_t count = std::size_t{1} << at(dim);
  double sum = 0, number = 0;
  for (std::size_t k = 0; k < count; ++k) {
    bool counts = true;
    for (std::size_t a = 0; a < at(dim); ++a) counts = counts && (half[a] < 0 || at(half[a]) == (k >> a & 1));
    if (counts) sum += parts[count * cell + k], ++number;
  }
  return sum / number;
}

double part_of_face(const CellParts& parts, const StaggeredGrid& grid, int axis, const std::array<int, 3>& face) {
  if (parts.empty()) return 1;
  double sum = 0, count = 0;
  for (const int lower : {1, 0}) {
    std::array<int, 3> cell = face, half = all_of_it;
    cell[at(axis)] -= lower, half[at(axis)] = lower;
    if (!grid.has_cell(cell)) continue;
    sum += mean_part(parts, grid.dim, grid.cell(cell), half), ++count;
  }
  return sum / count;
}

StrainRates::StrainRates(const FlowDomain& domain, const FrictionUnknowns& unknowns, const Slopes& slopes,
                         const CellParts& parts, Beyond beyond, double mu)
    : unknowns_(unknowns), domain_(&domain), slopes_(&slopes), parts_(&parts), beyond_(beyond), mu_(mu) {
  const int dim = unknowns.grid.dim;
  for (int a = 0; a < dim; ++a) {
    for (int b = a; b < dim; ++b) {
      weight_[at(a)][at(b)].assign(unknowns.lattice(), 0.0);
      stress_[at(a)][at(b)].assign(unknowns.lattice(), 0.0);
      a == b ? add_cells(a) : add_edges(a, b);
    }
  }
}

bool StrainRates::is_fluid(const std::array<int, 3>& cell) const {
  return unknowns_.grid.has_cell(cell) && domain_->kind[unknowns_.grid.cell(cell)] == CellKind::fluid;
}

double StrainRates::liquid_of(const std::array<int, 3>& cell, const std::array<int, 3>& half) const {
  return mean_part(*parts_, unknowns_.grid.dim, unknowns_.grid.cell(cell), half);
}

void StrainRates::add_square(const Combination& rate, double weight, bool of_two) {
  for (std::size_t k = 0; k < rate.size; ++k) unknown_.push_back(rate.unknown[k]), factor_.push_back(rate.factor[k]);
  first_.push_back(unknown_.size());
  square_weight_.push_back(weight);
  of_two_.push_back(of_two ? 1 : 0);
}

/// 2 mu D_aa^2.
void StrainRates::add_cells(int a) {
  const StaggeredGrid& grid = unknowns_.grid;
  const double mu = 2 * mu_ * grid.volume();
  each_place(grid.n, [&](const std::array<int, 3>& cell) {
    if (!is_fluid(cell)) return;
    const double liquid = liquid_of(cell, all_of_it);
    if (liquid == 0) return;
    const auto slopes = slopes_->ahead(a, cell);
    if (slopes_->is_whole(a, cell, a)) {
      weight_[at(a)][at(a)][unknowns_.place(cell)] = mu * liquid * slopes[0].part;
      return;
    }
    for (const Slope& slope : slopes) {
      if (slope.kind == Slope::Kind::fluid) add_square(slope.rate, mu * liquid * slope.part);
    }
  });
}

void StrainRates::add_edges(int a, int b) {
  std::array<int, 3> edges = unknowns_.grid.n;
  ++edges[at(a)], ++edges[at(b)];
  each_place(edges, [&](const std::array<int, 3>& corner) { add_edge(a, b, corner); });
}

/// All four cells about an edge have fluid, and nothing lies between their faces.
bool StrainRates::is_whole_edge(int a, int b, const std::array<int, 3>& corner) const {
  const auto before_a = moved(corner, a, -1), before_b = moved(corner, b, -1);
  return is_fluid(corner) && is_fluid(before_a) && is_fluid(before_b) && is_fluid(moved(before_a, b, -1)) &&
         slopes_->is_whole(a, before_b, b) && slopes_->is_whole(b, before_a, a);
}

void StrainRates::add_edge(int a, int b, const std::array<int, 3>& corner) {
  if (!is_whole_edge(a, b, corner)) {
    for (const bool upper_a : {false, true}) {
      for (const bool upper_b : {false, true}) add_quarter(a, b, corner, upper_a, upper_b);
    }
    return;
  }
  const auto before_a = moved(corner, a, -1), before_b = moved(corner, b, -1);
  double liquid = 0;
  for (const int i : {0, 1}) {
    for (const int j : {0, 1}) {
      std::array<int, 3> half = all_of_it;
      half[at(a)] = i, half[at(b)] = j;
      liquid += 0.25 * liquid_of(moved(moved(corner, a, -i), b, -j), half);
    }
  }
  const double part = std::max(
      {slopes_->part(a, corner), slopes_->part(a, before_b), slopes_->part(b, corner), slopes_->part(b, before_a)});
  weight_[at(a)][at(b)][unknowns_.place(corner)] = mu_ * unknowns_.grid.volume() * liquid * part;
}

/// The quarter of a cell that an edge has: the cell is on its upper or lower side along a and b.
void StrainRates::add_quarter(int a, int b, const std::array<int, 3>& corner, bool upper_a, bool upper_b) {
  const auto cell = moved(moved(corner, a, upper_a ? 0 : -1), b, upper_b ? 0 : -1);
  if (!is_fluid(cell)) return;
  std::array<int, 3> half = all_of_it;
  half[at(a)] = upper_a ? 0 : 1, half[at(b)] = upper_b ? 0 : 1;
  const double mu = 0.25 * mu_ * unknowns_.grid.volume() * liquid_of(cell, half);
  if (mu == 0) return;
  const auto face_a = moved(cell, a, upper_a ? 0 : 1), face_b = moved(cell, b, upper_b ? 0 : 1);
  Slope along_b = slopes_->across(a, face_a, b, !upper_b, face_b);
  const Slope along_a = slopes_->across(b, face_b, a, !upper_a, face_a);
  using Kind = Slope::Kind;
  if (along_a.kind == Kind::outside && along_b.kind == Kind::fluid && beyond_ == Beyond::fluid)
    return add_open_side(a, face_b, b, along_b, !upper_a, mu);
  if (along_b.kind == Kind::outside && along_a.kind == Kind::fluid && beyond_ == Beyond::fluid)
    return add_open_side(b, face_a, a, along_a, !upper_b, mu);
  if (along_a.kind == Kind::outside && along_b.kind == Kind::outside && beyond_ == Beyond::fluid)
    return add_open_corner(unknowns_.face(a, face_a), unknowns_.face(b, face_b), a, b, upper_a == upper_b ? mu : -mu);
  const auto ends = [](const Slope& slope) { return slope.kind == Kind::free || slope.kind == Kind::outside; };
  if (ends(along_a) || ends(along_b)) return;
  const double part = std::max(along_a.part, along_b.part);  // a solid's is 0
  along_b.rate.add(along_a.rate, 1);
  if (part > 0 && along_b.rate.size > 0) add_square(along_b.rate, mu * part);
}

/// At an open side across a the velocity v along b does not change on the way out, so that the shear stress there is
/// mu du/db. It acts on u within, and on v from outside: a force which is the derivative of
///     -+ mu A v du/db,
/// A the part of the side, minus at the upper one.
/// Where the fluid is free of divergence this term also makes of 2 mu du/da, the stress across the side, the mu du/da
/// of a flow that goes on: without both a flow between walls bends at its end, to be free of stress there.
void StrainRates::add_open_side(int a, const std::array<int, 3>& face_b, int b, const Slope& along_b, bool upper_side,
                                double mu) {
  add_square(along_b.rate, mu * along_b.part);
  const double length = 0.5 * unknowns_.grid.d[at(a)];  // of the quarter, across the side
  Combination change;                                   // of u from face to face
  change.add(along_b.rate, unknowns_.grid.d[at(b)]);
  add_product(change, unknowns_.face(b, face_b),
              (upper_side ? -1 : 1) * mu * along_b.part / (length * unknowns_.grid.d[at(b)]));
}

/// weight times a combination times an unknown v: ((sum + v)^2 - (sum - v)^2) / 4.
void StrainRates::add_product(const Combination& of, std::size_t v, double weight) {
  for (const int sign : {1, -1}) {
    Combination sum = of;
    sum.add(v, sign);
    add_square(sum, sign * 0.5 * weight, true);
  }
}

/// Where open sides across a and b meet, their terms -+ mu A v du/db and -+ mu A u dv/da each have half of the product
/// mu u v too much: v du/db = (v du/db - u dv/db) / 2 + d(u v)/db / 2. All but the last is as if the power were that of
/// |grad u|^2; it would feed a flow that goes along the sides.
void StrainRates::add_open_corner(std::size_t u, std::size_t v, int a, int b, double mu) {
  Combination alone;
  alone.add(u, 1);
  add_product(alone, v, 4 * mu / (unknowns_.grid.d[at(a)] * unknowns_.grid.d[at(b)]));
}

/// Of places begin to before end: mu times the rates.
void StrainRates::find_stresses(std::size_t a, std::size_t b, std::span<const double> x, std::size_t begin,
                                std::size_t end) {
  const double* u = x.data() + a * unknowns_.lattice();
  const double* v = x.data() + b * unknowns_.lattice();
  const double* weight = weight_[a][b].data();
  double* stress = stress_[a][b].data();
  const std::size_t stride_a = unknowns_.stride[a], stride_b = unknowns_.stride[b];
  const double per_a = 1 / unknowns_.grid.d[a], per_b = 1 / unknowns_.grid.d[b];
  if (a == b) {
    for (std::size_t p = begin; p < end; ++p) stress[p] = weight[p] * per_a * (u[p + stride_a] - u[p]);
  } else {
    for (std::size_t p = begin; p < end; ++p)
      stress[p] = weight[p] * (per_b * (u[p] - u[p - stride_b]) + per_a * (v[p] - v[p - stride_a]));
  }
}

void StrainRates::add_stresses(std::size_t a, std::size_t begin, std::size_t end, std::span<double> y) const {
  double* force = y.data() + a * unknowns_.lattice();
  for (std::size_t b = 0; b < at(unknowns_.grid.dim); ++b) {
    const double* stress = stress_[std::min(a, b)][std::max(a, b)].data();
    const std::size_t stride = unknowns_.stride[b];
    const double by = 1 / unknowns_.grid.d[b];
    if (a == b) {
      for (std::size_t p = begin; p < end; ++p) force[p] += by * (stress[p - stride] - stress[p]);
    } else {
      for (std::size_t p = begin; p < end; ++p) force[p] += by * (stress[p] - stress[p + stride]);
    }
  }
}

/// Finds the blocks that a liquid leaves rates in, and those that these, or the squares of the list, give forces.
void StrainRates::find_blocks() {
  const std::size_t size = places_of_a_block, blocks = (unknowns_.places + size - 1) / size;
  std::vector<std::uint8_t> rates(blocks, 0), forces(blocks, 0);
  const auto mark = [&](std::size_t place) {  // numbers of the margins have no forces
    if (place >= unknowns_.margin && place < unknowns_.margin + unknowns_.places)
      forces[(place - unknowns_.margin) / size] = 1;
  };
  for (std::size_t b = 0; b < blocks; ++b) {
    const std::size_t begin = unknowns_.margin + b * size,
                      last = unknowns_.margin + std::min(unknowns_.places, (b + 1) * size) - 1;
    for (const auto& of_axis : weight_) {
      for (const std::vector<double>& weight : of_axis) {
        for (std::size_t p = begin; !weight.empty() && p <= last && rates[b] == 0; ++p)
          rates[b] = weight[p] != 0 ? 1 : 0;
      }
    }
    for (std::size_t a = 0; rates[b] != 0 && a < at(unknowns_.grid.dim); ++a) {
      for (const std::size_t end : {begin, last})
        mark(end), mark(end - unknowns_.stride[a]), mark(end + unknowns_.stride[a]);
    }
  }
  for (const std::size_t number : unknown_) {
    if (number < unknowns_.node(0)) mark(number % unknowns_.lattice());
  }
  for (std::size_t b = 0; b < blocks; ++b) {
    if (rates[b] != 0) with_rates_.push_back(b);
    if (forces[b] != 0) with_forces_.push_back(b);
  }
}

void StrainRates::find_forces(Team& team, std::span<const double> x, std::span<double> y) {
  const std::size_t dim = at(unknowns_.grid.dim);
  const auto each = [&](const std::vector<std::size_t>& blocks, const auto& f) {
    team.each(0, blocks.size(), [&](std::size_t k) {
      const std::size_t begin = blocks[k] * places_of_a_block,
                        end = std::min(unknowns_.places, begin + places_of_a_block);
      f(begin + unknowns_.margin, end + unknowns_.margin);
    });
  };
  each(with_rates_, [&](std::size_t begin, std::size_t end) {
    for (std::size_t a = 0; a < dim; ++a) {
      for (std::size_t b = a; b < dim; ++b) find_stresses(a, b, x, begin, end);
    }
  });
  each(with_forces_, [&](std::size_t begin, std::size_t end) {
    for (std::size_t a = 0; a < dim; ++a) {
      std::ranges::fill(y.subspan(a * unknowns_.lattice() + begin, end - begin), 0.0);
      add_stresses(a, begin, end, y);
    }
  });
  std::ranges::fill(y.subspan(unknowns_.node(0)), 0.0);
  for (std::size_t s = 0; s + 1 < first_.size(); ++s) {
    double rate = 0;
    for (std::size_t k = first_[s]; k < first_[s + 1]; ++k) rate += factor_[k] * x[unknown_[k]];
    for (std::size_t k = first_[s]; k < first_[s + 1]; ++k) y[unknown_[k]] += square_weight_[s] * rate * factor_[k];
  }
}

void StrainRates::add_diagonal(std::span<double> y) const {
  const std::size_t dim = at(unknowns_.grid.dim);
  for (std::size_t a = 0; a < dim; ++a) {
    for (std::size_t b = 0; b < dim; ++b) {
      const std::vector<double>& weight = weight_[std::min(a, b)][std::max(a, b)];
      const std::size_t stride = unknowns_.stride[b];
      const double by = 1 / (unknowns_.grid.d[b] * unknowns_.grid.d[b]);
      for (std::size_t p = unknowns_.margin; p < unknowns_.margin + unknowns_.places; ++p)
        y[a * unknowns_.lattice() + p] += by * (weight[p] + (a == b ? weight[p - stride] : weight[p + stride]));
    }
  }
  for (std::size_t s = 0; s + 1 < first_.size(); ++s) {
    for (std::size_t k = first_[s]; k < first_[s + 1]; ++k)
      y[unknown_[k]] += square_weight_[s] * factor_[k] * factor_[k];
  }
}

}  // namespace tether::coupled
