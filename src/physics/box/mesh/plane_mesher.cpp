// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/mesh/plane_mesher.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "physics/box/mesh/boundary_faces.hpp"
#include "physics/box/mesh/lattice_points.hpp"

namespace tether::coupled {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
/// Of each triangle: 1 fluid, 0 not, -1 not known yet.
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using FaceBase =
    CGAL::Constrained_triangulation_face_base_2<Kernel, CGAL::Triangulation_face_base_with_info_2<int, Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
/// Segments that cross each other are cut where they do.
using Triangulation = CGAL::Constrained_triangulation_plus_2<
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::Exact_predicates_tag>>;
using Segment = Outline::Facet;

constexpr int unknown = -1;
constexpr double flat = 1e-9;  // of the mesh's size: lower triangles hold no fluid

class PlaneMesher {
 public:
  explicit PlaneMesher(const Outline& outline) : outline_(outline) {}

  FlowMesh mesh(const MeshSizes& sizes) {
    insert_outline();
    for (const Vec<3>& x : lattice_points(outline_, sizes)) triangulation_.insert(Kernel::Point_2(x[0], x[1]));
    mark_fluid();
    leave_out_flat(flat * sizes.size);
    FlowMesh mesh = triangles();
    mesh.find_faces();
    set_boundaries(mesh);
    return mesh;
  }

 private:
  void insert_outline() {
    std::vector<Triangulation::Vertex_handle> vertices;
    for (const Vec<3>& x : outline_.places) vertices.push_back(triangulation_.insert(Kernel::Point_2(x[0], x[1])));
    for (const Segment& segment : outline_.facets) {
      const auto a = vertices[segment.corners[0]], b = vertices[segment.corners[1]];
      if (a != b) parts_.push_back({&segment, triangulation_.insert_constraint(a, b), a});
    }
  }

  /// Walks along all segments, from vertex to vertex that they pass, and calls f(segment, triangle to the right, the
  /// edge in it, from, to).
  template <class Function>
  void each_edge(const Function& f) const {
    for (const Part& part : parts_) {
      std::vector<Triangulation::Vertex_handle> way(triangulation_.vertices_in_constraint_begin(part.constraint),
                                                    triangulation_.vertices_in_constraint_end(part.constraint));
      if (way.front() != part.from) std::reverse(way.begin(), way.end());
      for (std::size_t k = 0; k + 1 < way.size(); ++k) {
        Triangulation::Face_handle right;
        int index = 0;
        if (triangulation_.is_edge(way[k], way[k + 1], right, index))
          f(*part.segment, right, index, way[k], way[k + 1]);
      }
    }
  }

  /// What is to the left of segments is no fluid, whatever else it is to the right of: solids and obstacles that touch
  /// or cross have no fluid between them. What is to the right of one then is. Both go on through edges that are no
  /// segments.
  void mark_fluid() {
    for (auto face = triangulation_.all_faces_begin(); face != triangulation_.all_faces_end(); ++face)
      face->info() = unknown;
    for (const int mark : {0, 1}) {
      std::vector<Triangulation::Face_handle> next;
      const auto reach = [&](Triangulation::Face_handle face) {
        if (triangulation_.is_infinite(face) || face->info() != unknown) return;
        face->info() = mark, next.push_back(face);
      };
      each_edge([&](const Segment& segment, Triangulation::Face_handle right, int index, auto, auto) {
        if (mark == 0) reach(right->neighbor(index));
        if (mark == 1 && segment.has_fluid) reach(right);
      });
      while (!next.empty()) {
        const Triangulation::Face_handle face = next.back();
        next.pop_back();
        for (int k = 0; k < 3; ++k) {
          if (!face->is_constrained(k)) reach(face->neighbor(k));
        }
      }
    }
  }

  /// Triangles lower than this have no fluid, as between sides that cross at a small angle [least: length].
  void leave_out_flat(double least) {
    for (auto face = triangulation_.finite_faces_begin(); face != triangulation_.finite_faces_end(); ++face) {
      if (face->info() != 1) continue;
      double longest = 0;
      for (int k = 0; k < 3; ++k)
        longest =
            std::max(longest, CGAL::squared_distance(face->vertex(k)->point(), face->vertex((k + 1) % 3)->point()));
      const auto& a = face->vertex(0)->point();
      const Kernel::Vector_2 u = face->vertex(1)->point() - a, v = face->vertex(2)->point() - a;
      if (u.x() * v.y() - u.y() * v.x() <= least * std::sqrt(longest)) face->info() = 0;
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
    BoundaryFaces faces(mesh);
    each_edge([&](const Segment& segment, Triangulation::Face_handle, int, auto from, auto to) {
      faces.set({from->info(), to->info(), -1}, segment.boundary);
    });
    faces.close_left();
  }

  /// A segment, and where it begins.
  struct Part {
    const Segment* segment;
    Triangulation::Constraint_id constraint;
    Triangulation::Vertex_handle from;
  };
  const Outline& outline_;
  Triangulation triangulation_;
  std::vector<Part> parts_;
};

}  // namespace

FlowMesh plane_mesh(const Outline& outline, const MeshSizes& sizes) { return PlaneMesher(outline).mesh(sizes); }

}  // namespace tether::coupled
