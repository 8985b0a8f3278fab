// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/block_mesh.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "grid/mesh.hpp"
#include "grid/mesh_extent.hpp"

namespace tether {
namespace {

bool coincide(const Mesh& mesh, std::size_t a, std::size_t b, double within) {
  const auto dim = static_cast<std::size_t>(mesh.dim());
  for (std::size_t i = 0; i < dim; ++i) {
    if (std::abs(mesh.x[a * dim + i] - mesh.x[b * dim + i]) > within) return false;
  }
  return true;
}

}  // namespace

/// Neighbours in x are looked through.
std::vector<int> lowest_at_place(const Mesh& mesh) {
  const auto dim = static_cast<std::size_t>(mesh.dim());
  const double within = coincident * MeshExtent(mesh).size();
  std::vector<std::size_t> by_x(mesh.node_count());
  std::iota(by_x.begin(), by_x.end(), std::size_t{0});
  std::sort(by_x.begin(), by_x.end(), [&](std::size_t a, std::size_t b) {
    for (std::size_t i = 0; i < dim; ++i) {  // planes of x within the tolerance count as one
      const double difference = mesh.x[a * dim + i] - mesh.x[b * dim + i];
      if (std::abs(difference) > within) return difference < 0;
    }
    return a < b;
  });
  std::vector<int> lowest(mesh.node_count());
  for (std::size_t k = 0; k < by_x.size(); ++k) {
    const bool again = k > 0 && coincide(mesh, by_x[k - 1], by_x[k], within);
    lowest[by_x[k]] = again ? lowest[by_x[k - 1]] : static_cast<int>(by_x[k]);
  }
  return lowest;
}

std::vector<int> join_nodes(Mesh& mesh) {
  const auto dim = static_cast<std::size_t>(mesh.dim());
  const std::vector<int> lowest = lowest_at_place(mesh);
  std::vector<int> number(lowest.size());
  std::vector<double> x;
  for (std::size_t n = 0; n < lowest.size(); ++n) {
    if (lowest[n] != static_cast<int>(n)) {
      number[n] = number[static_cast<std::size_t>(lowest[n])];
      continue;
    }
    number[n] = static_cast<int>(x.size() / dim);
    x.insert(x.end(), &mesh.x[n * dim], &mesh.x[n * dim] + dim);
  }
  for (int& node : mesh.nodes) node = number[static_cast<std::size_t>(node)];
  mesh.x = std::move(x);
  return number;
}

namespace {

/// Part of the length at which line k of n cells stands whose sizes grow by a constant ratio, from first to last by
/// `grading`; a half-integer k is the middle of a cell.
double graded(double k, int n, double grading) {
  if (n == 1 || grading == 1) return k / n;
  const double ratio = std::pow(grading, 1.0 / (n - 1));
  const double whole = std::floor(k), part = k - whole;
  const auto up_to = [&](double cells) { return (std::pow(ratio, cells) - 1) / (std::pow(ratio, n) - 1); };
  return (1 - part) * up_to(whole) + part * up_to(whole + 1);
}

/// Returns the same for sizes that are symmetric about the middle and grow by a constant ratio from both ends to it,
/// where the cell, or the two, are `middle` times as long as those at the ends.
double graded_from_both(double k, int n, double middle) {
  if (n < 3 || middle == 1) return k / n;
  if (k > 0.5 * n) return 1 - graded_from_both(n - k, n, middle);
  const double rate = std::log(middle) / ((n - 1) / 2), whole = std::floor(k);
  const auto up_to = [&](double cells) { return std::expm1(rate * cells) / std::expm1(rate); };
  const double half = up_to(n / 2) + (n % 2 == 1 ? 0.5 * middle : 0);
  return (up_to(whole) + (k - whole) * std::exp(rate * whole)) / (2 * half);
}

/// Transfinite interpolation (W. J. Gordon and C. A. Hall, Int. J. Numer. Meth. Engng 7 (1973) 461-477).
Vec<2> mapped(const Block& block, double s, double t) {
  const Vec<2> bottom = block.edges[0](s), right = block.edges[1](t), top = block.edges[2](1 - s),
               left = block.edges[3](1 - t);
  const Vec<2> c0 = block.edges[0](0), c1 = block.edges[1](0), c2 = block.edges[2](0), c3 = block.edges[3](0);
  Vec<2> at;
  for (std::size_t i = 0; i < 2; ++i) {
    at[i] = (1 - t) * bottom[i] + s * right[i] + t * top[i] + (1 - s) * left[i] -
            ((1 - s) * (1 - t) * c0[i] + s * (1 - t) * c1[i] + s * t * c2[i] + (1 - s) * t * c3[i]);
  }
  return at;
}

/// The lattice of one block's nodes, from 0.
class Lattice {
 public:
  Lattice(const Block& block, ElementKind kind) : block_(block), p_(order_of(kind)), dim_(dimension_of(kind)) {
    for (int k = 0; k < 3; ++k) {
      const auto axis = static_cast<std::size_t>(k);
      lines_[axis] = k < dim_ ? p_ * block.cells[axis] + 1 : 1;
    }
  }
  int node(int i, int j, int k) const { return i + lines_[0] * (j + lines_[1] * k); }
  /// Appends the places of all nodes.
  void add_places(std::vector<double>& x) const {
    for (int k = 0; k < lines_[2]; ++k) {
      for (int j = 0; j < lines_[1]; ++j) {
        for (int i = 0; i < lines_[0]; ++i) {
          const Vec<2> at = mapped(block_, part(i, 0), part(j, 1));
          x.insert(x.end(), at.begin(), at.end());
          if (dim_ == 3) x.push_back(block_.z_low + part(k, 2) * (block_.z_high - block_.z_low));
        }
      }
    }
  }
  /// Nodes of the box element at cell (i, j, k).
  std::vector<int> box(int i, int j, int k) const {
    std::vector<int> nodes;
    for (int c = 0; c <= (dim_ == 3 ? p_ : 0); ++c) {
      for (int b = 0; b <= p_; ++b) {
        for (int a = 0; a <= p_; ++a) nodes.push_back(node(p_ * i + a, p_ * j + b, p_ * k + c));
      }
    }
    return nodes;
  }

 private:
  double part(int line, std::size_t axis) const {
    const double k = static_cast<double>(line) / p_;
    const int n = block_.cells[axis];
    return block_.grading_middle[axis] == 1 ? graded(k, n, block_.grading[axis])
                                            : graded_from_both(k, n, block_.grading_middle[axis]);
  }
  const Block& block_;
  int p_, dim_;
  std::array<int, 3> lines_{};
};

/// Corner k of a box is at the high end of x, y, z where k has 1, 2, 4.
constexpr std::array<std::array<int, 3>, 2> triangles{{{0, 1, 3}, {0, 3, 2}}};
using Tetrahedra = std::array<std::array<int, 4>, 6>;

/// Corner k of a box that has p + 1 nodes a line.
int corner_of_box(ElementKind kind, int k) {
  const int p = order_of(kind), line = p + 1;
  return p * ((k & 1) + line * ((k >> 1 & 1) + line * (k >> 2 & 1)));
}

/// The lowest corner with two triangles of each face that it is not on, which the face's lowest corner begins. Each
/// face is so parted from its lowest corner on, whichever way the blocks on its two sides are turned.
Tetrahedra tetrahedra(ElementKind kind, const std::vector<int>& box, const std::vector<int>& number) {
  const auto of_corner = [&](int k) {
    return number[static_cast<std::size_t>(box[static_cast<std::size_t>(corner_of_box(kind, k))])];
  };
  const auto lower = [&](int a, int b) { return of_corner(a) < of_corner(b); };
  constexpr std::array corners{0, 1, 2, 3, 4, 5, 6, 7};
  const int lowest = *std::min_element(corners.begin(), corners.end(), lower);
  Tetrahedra parts{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int own = 1 << axis, one = 1 << (axis + 1) % 3, other = 1 << (axis + 2) % 3, base = ~lowest & own;
    std::array face{base, base | one, base | one | other, base | other};
    if ((lowest & own) != 0) std::swap(face[1], face[3]);
    std::rotate(face.begin(), std::min_element(face.begin(), face.end(), lower), face.end());
    parts[2 * axis] = {lowest, face[0], face[1], face[2]};
    parts[2 * axis + 1] = {lowest, face[0], face[2], face[3]};
  }
  return parts;
}

/// Appends the nodes of a triangle or tetrahedron with these corners of a box: those between two corners are those of
/// the box's own lattice.
template <std::size_t count>
void add_simplex(const std::vector<int>& box, const std::array<int, count>& corners, Mesh& mesh) {
  const auto at = [&](int k) { return corner_of_box(mesh.kind, corners[static_cast<std::size_t>(k)]); };
  for (int a = 0; a < corner_count_of(mesh.kind); ++a) mesh.nodes.push_back(box[static_cast<std::size_t>(at(a))]);
  for (int m = corner_count_of(mesh.kind); m < node_count_of(mesh.kind); ++m) {
    const auto [a, b] = ends_of_middle[static_cast<std::size_t>(m - corner_count_of(mesh.kind))];
    mesh.nodes.push_back(box[static_cast<std::size_t>((at(a) + at(b)) / 2)]);
  }
}

void add_elements(const std::vector<int>& box, int region, const std::vector<int>& number, Mesh& mesh) {
  if (!is_simplex(mesh.kind)) {
    mesh.nodes.insert(mesh.nodes.end(), box.begin(), box.end());
    mesh.region.push_back(region);
  } else if (mesh.dim() == 2) {
    for (const auto& corners : triangles) add_simplex(box, corners, mesh), mesh.region.push_back(region);
  } else {
    for (const auto& corners : tetrahedra(mesh.kind, box, number))
      add_simplex(box, corners, mesh), mesh.region.push_back(region);
  }
}

/// `number` is one number for each place, of nodes in the order of blocks.
void add_elements_of(const Block& block, int region, int first, const std::vector<int>& number, Mesh& mesh) {
  const Lattice lattice(block, mesh.kind);
  for (int k = 0; k < (mesh.dim() == 3 ? block.cells[2] : 1); ++k) {
    for (int j = 0; j < block.cells[1]; ++j) {
      for (int i = 0; i < block.cells[0]; ++i) {
        std::vector<int> box = lattice.box(i, j, k);
        for (int& node : box) node += first;
        add_elements(box, region, number, mesh);
      }
    }
  }
}

/// Which of the block's six sides all these nodes lie on, as numbers of Block::names; -1 for none. Nodes of a block are
/// consecutive and stand on its lattice.
int side_number(const Block& block, ElementKind kind, const int* nodes, int count, int first) {
  const int p = order_of(kind), dim = dimension_of(kind);
  const int nx = p * block.cells[0] + 1, ny = p * block.cells[1] + 1, nz = dim == 3 ? p * block.cells[2] + 1 : 1;
  bool on[6] = {true, true, true, true, dim == 3, dim == 3};
  for (int a = 0; a < count; ++a) {
    const int at = nodes[a] - first, i = at % nx, j = at / nx % ny, k = at / nx / ny;
    on[0] &= j == 0, on[1] &= i == nx - 1, on[2] &= j == ny - 1, on[3] &= i == 0, on[4] &= k == 0, on[5] &= k == nz - 1;
  }
  const auto number = std::find(on, on + 6, true) - on;
  return number < 6 ? static_cast<int>(number) : -1;
}

constexpr const char* own_names[6] = {"bottom", "right", "top", "left", "back", "front"};

/// Sides of one block by their names, before its nodes are joined with those of others.
using NamedSides = std::vector<std::pair<std::string, std::vector<int>>>;

NamedSides named_sides(const std::vector<Block>& blocks, const Mesh& mesh, const std::vector<int>& first_node) {
  const int per_side = side_node_count_of(mesh.kind);
  NamedSides named;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const auto b = static_cast<std::size_t>(mesh.region[e]);
    Sides sides;
    add_sides(mesh.kind, mesh.element(e), sides);
    for (std::size_t s = 0; s < sides.size(); s += static_cast<std::size_t>(per_side)) {
      const int number = side_number(blocks[b], mesh.kind, &sides[s], per_side, first_node[b]);
      if (number < 0) continue;
      const auto begin = sides.begin() + static_cast<std::ptrdiff_t>(s);
      const std::vector<int> nodes(begin, begin + per_side);
      named.emplace_back(fmt::format("{}.{}", number_of(blocks, b), own_names[number]), nodes);
      const std::string& given = blocks[b].names[static_cast<std::size_t>(number)];
      if (!given.empty()) named.emplace_back(given, nodes);
    }
  }
  return named;
}

}  // namespace

EdgeCurve straight(Vec<2> from, Vec<2> to) {
  return [=](double s) -> Vec<2> { return {(1 - s) * from[0] + s * to[0], (1 - s) * from[1] + s * to[1]}; };
}

EdgeCurve elliptic(Vec<2> from, Vec<2> to, Vec<2> centre, double a, double b) {
  const auto angle = [&](const Vec<2>& at) { return std::atan2((at[1] - centre[1]) / b, (at[0] - centre[0]) / a); };
  const double begin = angle(from);
  const double turn = std::remainder(angle(to) - begin, 2 * std::numbers::pi);
  return [=](double s) -> Vec<2> {
    if (s == 0) return from;
    if (s == 1) return to;
    return {centre[0] + a * std::cos(begin + s * turn), centre[1] + b * std::sin(begin + s * turn)};
  };
}

int number_of(const std::vector<Block>& blocks, std::size_t b) {
  return blocks[b].number > 0 ? blocks[b].number : static_cast<int>(b) + 1;
}

Mesh mesh_of_blocks(const std::vector<Block>& blocks, ElementKind kind, std::vector<MeshFlaw>& flaws) {
  Mesh mesh;
  mesh.kind = kind;
  std::vector<int> first_node;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    first_node.push_back(static_cast<int>(mesh.node_count()));
    Lattice(blocks[b], kind).add_places(mesh.x);
  }
  const std::vector<int> number = lowest_at_place(mesh);
  for (std::size_t b = 0; b < blocks.size(); ++b)
    add_elements_of(blocks[b], static_cast<int>(b), first_node[b], number, mesh);
  NamedSides named = named_sides(blocks, mesh, first_node);
  const std::vector<int> renumbered = join_nodes(mesh);
  for (auto& [name, nodes] : named) {
    for (int& node : nodes) node = renumbered[static_cast<std::size_t>(node)];
    mesh.sides[name].insert(mesh.sides[name].end(), nodes.begin(), nodes.end());
  }
  drop_twins(mesh);
  find_inverted(mesh, flaws);
  std::vector<int> numbers;
  for (std::size_t b = 0; b < blocks.size(); ++b) numbers.push_back(number_of(blocks, b));
  if (blocks.size() > 1) find_hanging(mesh, numbers, flaws);
  return mesh;
}

}  // namespace tether
