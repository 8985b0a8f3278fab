// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/mesh/plane_mesher.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/numbers.hpp"
#include "physics/box/mesh/boundary_faces.hpp"
#include "physics/box/mesh/lattice_points.hpp"

namespace tether::coupled {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
/// Of each triangle what is in it, `unknown` to begin with.
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using FaceBase =
    CGAL::Constrained_triangulation_face_base_2<Kernel, CGAL::Triangulation_face_base_with_info_2<int, Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
/// Segments that cross each other are cut where they do.
using Triangulation = CGAL::Constrained_triangulation_plus_2<
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::Exact_predicates_tag>>;
using Segment = Outline::Facet;

constexpr int unknown = -1, solid = 0, fluid = 1, empty = 2;  // empty: no body has it, but the fluid does not reach it
constexpr double flat = 1e-9;                                 // of the mesh's size: lower triangles hold no fluid

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

  /// Rooms between segments are solid where a body or an obstacle goes around them, and where several do. A surface
  /// that crosses itself changes no room but those within its loops. What is to the right of segments then is fluid.
  void mark_fluid() {
    for (auto face = triangulation_.all_faces_begin(); face != triangulation_.all_faces_end(); ++face)
      face->info() = unknown;
    for (auto face = triangulation_.finite_faces_begin(); face != triangulation_.finite_faces_end(); ++face) {
      if (face->info() != unknown) continue;
      const auto largest = mark_room(face, empty);
      if (turns_around(CGAL::centroid(triangulation_.triangle(largest))) != 0) mark_room(face, solid);
    }
    each_edge([&](const Segment& segment, Triangulation::Face_handle right, int, auto, auto) {
      if (segment.has_fluid && right->info() == empty) mark_room(right, fluid);
    });
  }

  /// Marks all triangles from one up to segments, and returns the largest.
  Triangulation::Face_handle mark_room(Triangulation::Face_handle first, int mark) {
    std::vector<Triangulation::Face_handle> next;
    Triangulation::Face_handle largest = first;
    const auto reach = [&](Triangulation::Face_handle face) {
      if (triangulation_.is_infinite(face) || face->info() == mark) return;
      face->info() = mark, next.push_back(face);
    };
    for (reach(first); !next.empty();) {
      const Triangulation::Face_handle face = next.back();
      next.pop_back();
      if (triangulation_.triangle(face).area() > triangulation_.triangle(largest).area()) largest = face;
      for (int k = 0; k < 3; ++k) {
        if (!face->is_constrained(k)) reach(face->neighbor(k));
      }
    }
    return largest;
  }

  /// How often the surfaces of bodies and obstacles go around a place: the sum of the angles that they are seen at.
  int turns_around(const Kernel::Point_2& x) const {
    double angle = 0;
    for (const auto& [from, to] : outline_.around) {
      const Vec<3> u = minus(from, {x.x(), x.y(), 0}), v = minus(to, {x.x(), x.y(), 0});
      angle += std::atan2(u[0] * v[1] - u[1] * v[0], dot(u, v));
    }
    return static_cast<int>(std::lround(angle / (2 * std::numbers::pi)));
  }

  /// Triangles lower than this have no fluid, as between sides that cross at a small angle [least: length].
  void leave_out_flat(double least) {
    for (auto face = triangulation_.finite_faces_begin(); face != triangulation_.finite_faces_end(); ++face) {
      if (face->info() != fluid) continue;
      double longest = 0;
      for (int k = 0; k < 3; ++k)
        longest =
            std::max(longest, CGAL::squared_distance(face->vertex(k)->point(), face->vertex((k + 1) % 3)->point()));
      const auto& a = face->vertex(0)->point();
      const Kernel::Vector_2 u = face->vertex(1)->point() - a, v = face->vertex(2)->point() - a;
      if (u.x() * v.y() - u.y() * v.x() <= least * std::sqrt(longest)) face->info() = solid;
    }
  }

  FlowMesh triangles() {
    FlowMesh mesh;
    for (auto v = triangulation_.finite_vertices_begin(); v != triangulation_.finite_vertices_end(); ++v)
      v->info() = unknown;
    for (auto face = triangulation_.finite_faces_begin(); face != triangulation_.finite_faces_end(); ++face) {
      if (face->info() != fluid) continue;
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
