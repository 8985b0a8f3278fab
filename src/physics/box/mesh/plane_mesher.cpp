// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/mesh/plane_mesher.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "base/diagnostics.hpp"
#include "base/numbers.hpp"
#include "physics/box/mesh/lattice_points.hpp"

namespace tether::coupled {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
/// Of each triangle: 1 fluid, 0 not, -1 not known yet.
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using FaceBase =
    CGAL::Constrained_triangulation_face_base_2<Kernel, CGAL::Triangulation_face_base_with_info_2<int, Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure,
                                               CGAL::No_constraint_intersection_requiring_constructions_tag>;

constexpr int unknown = -1;

class PlaneMesher {
 public:
  explicit PlaneMesher(const PlaneOutline& outline) : outline_(outline) {}

  FlowMesh mesh(const MeshSizes& sizes) {
    insert_outline();
    for (const Vec<3>& x : lattice_points(outline_, sizes)) triangulation_.insert(Kernel::Point_2(x[0], x[1]));
    mark_fluid();
    FlowMesh mesh = triangles();
    mesh.find_faces();
    set_boundaries(mesh);
    return mesh;
  }

 private:
  void insert_outline() {
    for (const Vec<3>& x : outline_.places) vertices_.push_back(triangulation_.insert(Kernel::Point_2(x[0], x[1])));
    for (const PlaneOutline::Segment& segment : outline_.segments) {
      const auto a = vertices_[segment.ends[0]], b = vertices_[segment.ends[1]];
      if (a == b) continue;
      try {
        triangulation_.insert_constraint(a, b);
      } catch (const Triangulation::Intersection_of_constraints_exception&) {
        refuse(segment);
      }
    }
  }

  [[noreturn]] void refuse(const PlaneOutline::Segment& segment) const {
    const Vec<3>& x = outline_.places[segment.ends[0]];
    throw RunError(
        fmt::format("the surface of a body crosses another one, an obstacle or itself near ({:.6g}, {:.6g}): "
                    "a mesh of the fluid needs them apart; $contact keeps bodies apart",
                    x[0], x[1]));
  }

  /// Walks along a segment, from vertex to vertex that it passes, and calls f(triangle to its right, the edge in it,
  /// from, to).
  template <class Function>
  void each_edge(const PlaneOutline::Segment& segment, const Function& f) const {
    auto from = vertices_[segment.ends[0]];
    const auto to = vertices_[segment.ends[1]];
    while (from != to) {
      Triangulation::Vertex_handle next;
      Triangulation::Face_handle right;
      int index = 0;
      if (!triangulation_.includes_edge(from, to, next, right, index)) refuse(segment);
      f(right, index, from, next);
      from = next;
    }
  }

  /// What is to the left of segments is no fluid, whatever else it is to the right of: solids and obstacles that touch
  /// have no fluid between them. What is to the right of one then is. Both go on through edges that are no segments.
  void mark_fluid() {
    for (auto face = triangulation_.all_faces_begin(); face != triangulation_.all_faces_end(); ++face)
      face->info() = unknown;
    for (const int mark : {0, 1}) {
      std::vector<Triangulation::Face_handle> next;
      const auto reach = [&](Triangulation::Face_handle face) {
        if (triangulation_.is_infinite(face) || face->info() != unknown) return;
        face->info() = mark, next.push_back(face);
      };
      for (const PlaneOutline::Segment& segment : outline_.segments) {
        if (vertices_[segment.ends[0]] == vertices_[segment.ends[1]]) continue;
        each_edge(segment, [&](Triangulation::Face_handle right, int index, auto, auto) {
          reach(mark == 1 ? right : right->neighbor(index));
        });
      }
      while (!next.empty()) {
        const Triangulation::Face_handle face = next.back();
        next.pop_back();
        for (int k = 0; k < 3; ++k) {
          if (!face->is_constrained(k)) reach(face->neighbor(k));
        }
      }
    }
  }

  FlowMesh triangles() {
    FlowMesh mesh;
    for (auto v = triangulation_.finite_vertices_begin(); v != triangulation_.finite_vertices_end(); ++v)
      v->info() = unknown;
    for (auto face = triangulation_.finite_faces_begin(); face != triangulation_.finite_faces_end(); ++face) {
      if (face->info() != 1) continue;
      for (int k = 0; k < 3; ++k) {
        const auto vertex = face->vertex(k);
        if (vertex->info() == unknown) {
          vertex->info() = static_cast<int>(mesh.x.size());
          mesh.x.push_back({vertex->point().x(), vertex->point().y(), 0});
        }
        mesh.nodes.push_back(vertex->info());
      }
    }
    return mesh;
  }

  void set_boundaries(FlowMesh& mesh) const {
    std::unordered_map<long long, std::size_t> face_of;
    const auto key = [&](int a, int b) {
      return static_cast<long long>(std::min(a, b)) * static_cast<long long>(mesh.x.size()) + std::max(a, b);
    };
    for (std::size_t f = 0; f < mesh.faces(); ++f) {
      if (mesh.is_at_boundary(f)) face_of[key(mesh.face_nodes(f)[0], mesh.face_nodes(f)[1])] = f;
    }
    for (const PlaneOutline::Segment& segment : outline_.segments) {
      if (vertices_[segment.ends[0]] == vertices_[segment.ends[1]]) continue;
      each_edge(segment, [&](Triangulation::Face_handle, int, auto from, auto to) {
        const auto found = face_of.find(key(from->info(), to->info()));
        if (found != face_of.end()) mesh.boundary[found->second] = segment.boundary;
      });
    }
  }

  const PlaneOutline& outline_;
  Triangulation triangulation_;
  std::vector<Triangulation::Vertex_handle> vertices_;  // of the outline's places
};

}  // namespace

FlowMesh plane_mesh(const PlaneOutline& outline, const MeshSizes& sizes) { return PlaneMesher(outline).mesh(sizes); }

}  // namespace tether::coupled
