// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <map>

#include "read/mesh/solids_of_deck.hpp"

namespace tether {
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
  int left() const {
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(equations_);
    qr.setThreshold(1e-12);
    return static_cast<int>(equations_.cols() - qr.rank());
  }

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
