// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>

#include "algebra/dense.hpp"
#include "deck/spelling.hpp"
#include "grid/mesh_flaws.hpp"
#include "grid/overlaps.hpp"
#include "read/mesh/sides.hpp"
#include "read/mesh/solids.hpp"
#include "read/path.hpp"
#include "read/points/geometry.hpp"
#include "read/values.hpp"

namespace tether {
namespace {

void warn(const Deck& deck, const Variable& variable, Subscript at, const std::string& message, const std::string& hint,
          Diagnostics& diagnostics) {
  diagnostics.add(deck.remark(Severity::warning, AnyVariable(variable), at, message, hint));
}

/// Warns of what the deck says of points and membranes, other than what stands there by itself.
void warn_of_points(const Deck& deck, Diagnostics& diagnostics) {
  const bool box = deck.has_group("coupled");
  for (const Variable& variable : variables()) {
    if (is_of_meshes(variable)) continue;
    for (const Subscript at : deck.given_elements(AnyVariable(variable))) {
      if (is_default(deck, AnyVariable(variable), at)) continue;
      warn(deck, variable, at,
           fmt::format("{} of ${} has no effect {}", variable.name, variable.group,
                       box ? "beside $coupled" : "on a mesh"),
           box ? "a deck with $coupled runs its fluid and elements alone: no points, membranes, gas"
               : "a deck with $mesh runs its elements alone: no points, membranes, gas",
           diagnostics);
      break;
    }
  }
}

void warn_of_point_outputs(const Deck& deck, Diagnostics& diagnostics) {
  if (deck.given("flow.tracers", 1) || deck.logical("coupled.liquid")) return;  // which are written as points
  const bool box = deck.has_group("coupled");
  for (const int k : {13, 32, 35, 36, 40}) {
    if (deck.integer("in.iout", k) != 1) continue;
    diagnostics.add(deck.remark(
        Severity::warning, "in.iout", {k, 1},
        fmt::format("iout({})=1 writes nothing: {} no points", k, box ? "fluid and elements have" : "a mesh has"),
        box ? "iout(39)=1, tiout(39)=... writes the fields of fluid and elements"
            : "iout(39)=1, tiout(39)=... writes the mesh with its fields into mesh.nc"));
  }
}

/// Warns of numbers of regions that there are none of.
void warn_of_absent_regions(const Deck& deck, Diagnostics& diagnostics) {
  const int regions = deck.integer("reg.nreg");
  for (const Variable& variable : variables()) {
    const bool by_second = variable.rank == 2 && variable.n2 == region_count;
    const bool by_first = variable.rank == 1 && variable.n1 == region_count;
    const bool of_loads = variable.name.starts_with("load") || variable.name.starts_with("fix");
    const bool of_meshes = variable.group == "mesh" || variable.group == "fem" || variable.name == "penalty";
    if (!of_meshes || of_loads || !(by_first || by_second)) continue;
    for (const Subscript at : deck.given_elements(AnyVariable(variable))) {
      const int r = by_second ? at[1] : at[0];
      if (r <= regions) continue;
      warn(deck, variable, at, fmt::format("{} has no effect: there is no region {}", variable.name, r),
           fmt::format("nreg of $reg is {}", regions), diagnostics);
      break;
    }
  }
}

}  // namespace

void check_mesh_deck(const Deck& deck, Diagnostics& diagnostics) {
  if (!deck.has_group("rigid") && !deck.has_group("coupled") && geometry_of(deck) == Geometry::axisymmetric) {
    const bool flow = has_flow(deck);
    diagnostics.add(
        deck.remark(Severity::error, "in.cyl", {1, 1},
                    fmt::format("{} on a mesh {} no axis", flow ? "a fluid" : "elastic bodies", flow ? "has" : "have"),
                    flow ? "write cyl=0.: a fluid is plane"
                         : "write cyl=0.; a ring of revolution is a mesh in space, by z of the regions in $mesh"));
  }
  warn_of_points(deck, diagnostics);
  warn_of_point_outputs(deck, diagnostics);
  if (deck.has_group("mesh")) warn_of_absent_regions(deck, diagnostics);
}

void check_wall(const Deck& deck, const Mesh& mesh, const GridEdge& edge, std::size_t held, Diagnostics& diagnostics) {
  const auto dim = static_cast<std::size_t>(mesh.dim());
  const bool low = edge.variable == "in.wl" || edge.variable == "in.wb";
  const auto behind = [&](double x) { return (low ? edge.place - x : x - edge.place) > 1e-9 * edge.size; };
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    if (held == 0 || !behind(mesh.x[n * dim + edge.axis])) continue;
    diagnostics.add(deck.remark(
        Severity::error, edge.variable, {1, 1},
        fmt::format("the edge {} = {:.6g} of the grid goes through the body: its wall would hold {} nodes inside of it",
                    edge.axis == 0 ? "x" : "y", edge.place, held),
        fmt::format("write {}=1, or place the edge elsewhere", edge.variable)));
    return;
  }
}

void check_supports_agree(const Deck& deck, const Solids& solids, Diagnostics& diagnostics) {
  const auto dim = static_cast<std::size_t>(solids.mesh.dim());
  std::vector<const Support*> by(solids.mesh.x.size(), nullptr);
  const auto same = [](const Support& a, const Support& b, std::size_t i) {
    if (a.displacement[i] != b.displacement[i]) return false;
    return a.displacement[i] == 0 ||
           (a.amplitude.time == b.amplitude.time && a.amplitude.factor == b.amplitude.factor &&
            !a.amplitude.expression && !b.amplitude.expression);
  };
  for (const Support& support : solids.supports) {
    const Support* other = nullptr;
    std::size_t axis = 0;
    for (const int node : support.nodes) {
      for (std::size_t i = 0; i < dim; ++i) {
        const Support*& first = by[static_cast<std::size_t>(node) * dim + i];
        if (!support.fixed[i]) continue;
        if (first && !same(*first, support, i)) other = first, axis = i;
        first = &support;
      }
    }
    if (!other) continue;
    diagnostics.add(deck.remark(Severity::error, "fem.fix_on", {support.number, 1},
                                fmt::format("{} and {} move the same nodes along {} to different places",
                                            other->amplitude.of, support.amplitude.of, "xyz"[axis]),
                                "leave that direction away in one of them"));
  }
}

namespace {

/// Says which bodies overlap, and where.
class OverlapText {
 public:
  explicit OverlapText(const Solids& solids) : solids_(solids), parts_(parts_of(solids.mesh)) {}

  std::string of(const Overlap& found, double depth) const {
    const std::string where = fmt::format("node {} at {}", found.node + 1, place_text(solids_.mesh, found.node));
    if (found.part == found.other)
      return fmt::format("{} overlaps itself at the start: {} lies inside it", name(found.part), where);
    return fmt::format("{} lies inside both, {:.3g} from the nearest side of the latter",
                       both(found.part, found.other) + where, depth);
  }
  std::string of(const CrossedSides& crossed) const {
    return fmt::format("{}their sides cross at ({:.6g}, {:.6g}{})", both(crossed.part, crossed.other), crossed.place[0],
                       crossed.place[1], solids_.mesh.dim() == 3 ? fmt::format(", {:.6g}", crossed.place[2]) : "");
  }

 private:
  std::string both(int part, int other) const {
    return fmt::format("{} and {} overlap at the start: ", name(part), name(other));
  }
  std::string name(int part) const {
    std::size_t e = 0;
    while (parts_[static_cast<std::size_t>(solids_.mesh.element(e)[0])] != part) ++e;
    const auto region = static_cast<std::size_t>(solids_.mesh.region[e]);
    return fmt::format("body {} ({})", part + 1, solids_.regions[region].name);
  }

  const Solids& solids_;
  std::vector<int> parts_;
};

/// Returns whether contact stops one part of the bodies at another, or at itself.
bool is_stopped(const Solids& solids, int part, int other) {
  return solids.contact && (part == other ? solids.contact->itself : solids.contact->bodies);
}

}  // namespace

void check_overlaps(const Deck& deck, const Solids& solids, Diagnostics& diagnostics) {
  const Mesh& mesh = solids.mesh;
  OverlapFinder finder(mesh);
  const Overlap found = finder.find(mesh.x);
  const CrossedSides crossed = found.nodes == 0 ? finder.find_crossed(mesh.x) : CrossedSides{};
  if (found.nodes == 0 && crossed.part < 0) return;
  const OverlapText text(solids);
  const bool stopped =
      found.nodes == 0 ? is_stopped(solids, crossed.part, crossed.other) : is_stopped(solids, found.part, found.other);
  const bool file = !deck.text("mesh.file").empty();
  diagnostics.add(deck.remark(
      stopped ? Severity::error : Severity::warning, file ? AnyVariable("mesh.file") : "reg.nreg", {1, 1},
      found.nodes == 0 ? text.of(crossed) : text.of(found, finder.depth(found, mesh.x)),
      stopped ? "$contact stops bodies that start apart from one another: place them apart"
              : "nothing stops bodies at one another: what they do where they overlap is wrong; place them apart, and "
                "$contact keeps elastic ones so"));
}

namespace {

/// The rigid motions of the blocks of elements that hang together by whole sides, within a part of the mesh that hangs
/// together at all: at a single node two blocks are hinged. Equations: what supports hold, and that blocks agree where
/// they share nodes.
class Motions {
 public:
  Motions(const Mesh& mesh, const std::vector<int>& block) : mesh_(mesh), dim_(mesh.dim()), count_(dim_ == 2 ? 3 : 6) {
    const auto per_element = static_cast<std::size_t>(node_count_of(mesh.kind));
    for (std::size_t e = 0; e < mesh.element_count(); ++e) {
      for (std::size_t a = 0; a < per_element; ++a) {
        auto& blocks = of_node_[mesh.element(e)[a]];
        if (std::find(blocks.begin(), blocks.end(), block[e]) == blocks.end()) blocks.push_back(block[e]);
      }
    }
    const Eigen::Map<const Eigen::MatrixXd> x(mesh.x.data(), dim_, static_cast<Eigen::Index>(mesh.node_count()));
    const Eigen::VectorXd low = x.rowwise().minCoeff(), high = x.rowwise().maxCoeff();
    centre_ = (low + high) / 2, size_ = (high - low).maxCoeff() / 2;
    number_blocks();
    equations_ = Eigen::MatrixXd::Zero(unknowns(), unknowns());
    join();
  }

  void hold(int node, int axis) {
    const auto found = of_node_.find(node);
    if (found == of_node_.end()) return;
    add(row(node, axis, found->second.front()));
  }
  int left() const { return static_cast<int>(equations_.cols() - rank(equations_, 1e-12)); }

 private:
  Eigen::Index unknowns() const { return static_cast<Eigen::Index>(number_.size()) * count_; }
  void number_blocks() {
    for (const auto& [node, blocks] : of_node_) {
      for (const int block : blocks) number_.try_emplace(block, static_cast<Eigen::Index>(number_.size()));
    }
  }
  /// How a node moves along an axis by the motions of a block, lengths over the mesh's size.
  Eigen::VectorXd row(int node, int axis, int block) const {
    Eigen::VectorXd row = Eigen::VectorXd::Zero(unknowns());
    const Eigen::Index first = number_.at(block) * count_;
    const auto arm = [&](int i) {
      return (mesh_.x[static_cast<std::size_t>(node) * static_cast<std::size_t>(dim_) + static_cast<std::size_t>(i)] -
              centre_[i]) /
             size_;
    };
    row[first + axis] = 1;
    if (dim_ == 2) {
      row[first + 2] = axis == 0 ? -arm(1) : arm(0);
    } else {
      row[first + 3 + (axis + 1) % 3] = arm((axis + 2) % 3), row[first + 3 + (axis + 2) % 3] = -arm((axis + 1) % 3);
    }
    return row;
  }
  void add(const Eigen::VectorXd& row) { equations_ += row * row.transpose(); }
  void join() {
    for (const auto& [node, blocks] : of_node_) {
      for (std::size_t k = 1; k < blocks.size(); ++k) {
        for (int axis = 0; axis < dim_; ++axis) add(row(node, axis, blocks[k]) - row(node, axis, blocks[0]));
      }
    }
  }

  const Mesh& mesh_;
  int dim_, count_;
  std::map<int, std::vector<int>> of_node_;  // blocks
  std::map<int, Eigen::Index> number_;       // of each block
  Eigen::VectorXd centre_;
  double size_ = 1;
  Eigen::MatrixXd equations_;  // the sum of row row^T
};

/// The elements of one part as a mesh of their own, with the nodes of the whole.
Mesh part_of(const Mesh& mesh, const std::vector<int>& part, int which) {
  Mesh one;
  one.kind = mesh.kind, one.x = mesh.x;
  const auto per_element = static_cast<std::size_t>(node_count_of(mesh.kind));
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    if (part[static_cast<std::size_t>(mesh.element(e)[0])] != which) continue;
    one.nodes.insert(one.nodes.end(), mesh.element(e), mesh.element(e) + per_element);
    one.region.push_back(mesh.region[e]);
  }
  return one;
}

}  // namespace

int free_motions(const Solids& solids) {
  const std::vector<int> part = parts_of(solids.mesh);
  int left = 0;
  for (int p = 0; p < count_parts(solids.mesh); ++p) {
    const Mesh mesh = part_of(solids.mesh, part, p);
    Motions motions(mesh, blocks_by_sides(mesh));
    for (const Support& support : solids.supports) {
      for (const int node : support.nodes) {
        for (int i = 0; i < mesh.dim(); ++i) {
          if (support.fixed[static_cast<std::size_t>(i)]) motions.hold(node, i);
        }
      }
    }
    left = std::max(left, motions.left());
  }
  return left;
}

}  // namespace tether
