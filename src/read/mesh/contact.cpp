// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/mesh/contact.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>
#include <string>
#include <utility>

#include "base/numbers.hpp"
#include "base/vec.hpp"
#include "deck/words.hpp"
#include "grid/mesh_extent.hpp"
#include "grid/mesh_flaws.hpp"
#include "grid/solid_surface.hpp"
#include "model/coupled.hpp"
#include "read/mesh/contact_checks.hpp"
#include "read/mesh/sides.hpp"
#include "read/values.hpp"

namespace tether {
namespace {

/// Returns the second subscripts of the elements that the deck gives, each once, ascending.
std::set<int> numbers_of(const Deck& deck, AnyVariable name) {
  std::set<int> numbers;
  for (const Subscript at : deck.given_elements(name)) numbers.insert(at[1]);
  return numbers;
}

/// Returns the nodes of the bodies' surface, each once, ascending.
std::vector<int> surface_nodes(const Mesh& mesh) {
  std::vector<int> nodes = boundary_of(mesh);
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

std::vector<int> common_nodes(const std::vector<int>& a, const std::vector<int>& b) {
  std::vector<int> nodes;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(nodes));
  return nodes;
}

/// Returns how deep a place lies in a box of so many dimensions: negative outside [length].
double depth_in(const Box<3>& box, const Vec<3>& place, int dim) {
  double depth = INFINITY;
  for (std::size_t i = 0; i < at(dim); ++i) depth = std::min({depth, place[i] - box.low[i], box.high[i] - place[i]});
  return depth;
}

/// Reads $contact and reports what is wrong with it.
class ContactReader {
 public:
  /// `walls`: sides of the box that stop bodies without $contact.
  ContactReader(const Deck& deck, const Scene& scene, const Solids& solids, const std::set<int>& walls,
                Diagnostics& diagnostics)
      : deck_(deck),
        scene_(scene),
        solids_(solids),
        diagnostics_(diagnostics),
        dim_(solids.mesh.dim()),
        meeting_(surface_nodes(solids.mesh)),
        rounding_(coincident * MeshExtent(solids.mesh).size()),
        walls_(walls) {}

  Contact read() {
    read_law();
    read_parts();
    for (const Subscript at : deck_.given_elements("contact.wall")) add_wall(at[0]);
    for (const int k : numbers_of(deck_, "contact.plane")) add_plane(k);
    for (const int k : numbers_of(deck_, "contact.obstacle")) add_obstacle(k);
    check_integrator();
    check_anything_meets();
    return std::move(contact_);
  }

 private:
  void error(AnyVariable name, Subscript at, const std::string& message, const std::string& hint) {
    refuse(deck_, name, at, message, hint, diagnostics_);
  }
  void warn(AnyVariable name, Subscript at, const std::string& message, const std::string& hint) {
    diagnostics_.add(deck_.remark(Severity::warning, name, at, message, hint));
  }

  void read_law() {
    const auto number = [&](RealVariable name) { return deck_.given(name) ? deck_.real(name) : 0; };
    contact_.gap = number("contact.gap");
    contact_.stiffness = number("contact.stiffness");
    contact_.friction = deck_.real("contact.friction");
    contact_.stick = number("contact.stick");
    contact_.step = word<ContactStep>(deck_, "contact.step");
    contact_.parts = static_cast<int>(deck_.integer("contact.parts"));
    contact_.bodies = deck_.logical("contact.bodies");
    contact_.itself = deck_.logical("contact.itself");
    if (contact_.stick > 0 && contact_.friction == 0)
      warn("contact.stick", {1, 1}, "stick of $contact has no effect: there is no friction",
           "friction is Coulomb's coefficient");
  }

  /// Reads what can meet something; each name has a part of the surface.
  void read_parts() {
    const auto named = deck_.given_elements("contact.on");
    for (const Subscript at : named) {
      const std::vector<int> nodes = named_nodes(deck_, "contact.on", at[0], solids_, diagnostics_);
      contact_.nodes.insert(contact_.nodes.end(), nodes.begin(), nodes.end());
      if (!nodes.empty() && common_nodes(nodes, meeting_).empty())
        error("contact.on", at,
              fmt::format("'{}' has no node on the surface of the bodies: nothing can meet it",
                          deck_.text("contact.on", at[0])),
              "write the name of an outer side, or 'region r' of a region that has one");
    }
    if (named.empty()) return;
    std::sort(contact_.nodes.begin(), contact_.nodes.end());
    contact_.nodes.erase(std::unique(contact_.nodes.begin(), contact_.nodes.end()), contact_.nodes.end());
    meeting_ = common_nodes(contact_.nodes, meeting_);
  }

  void add_wall(int k) {
    const std::string name = deck_.text("contact.wall", k);
    const auto side = static_cast<int>(std::ranges::find(box_side_names, name) - box_side_names.begin());
    if (axis_of_side(side) == 2)
      return error("contact.wall", {k, 1}, fmt::format("the box of $in has no {}: it has no ends along z", name),
                   dim_ == 3 ? fmt::format("plane(1,k)=0.,0.,z, 0.,0.,{}. is a wall at z", is_low_side(side) ? 1 : -1)
                             : "the mesh is plane: leave it away");
    if (!walls_.insert(side).second)
      return error("contact.wall", {k, 1}, fmt::format("the {} is a wall already", name), "name each side once");
    const GridEdge edge = edges_of(scene_)[at(side)];
    SurfacePlane plane;
    plane.place = {scene_.grid.x0, scene_.grid.y0, 0};
    plane.place[edge.axis] = edge.place;
    plane.normal[edge.axis] = is_low_side(side) ? 1 : -1;
    check_held(k, edge);
    add(plane, "contact.wall", {k, 1}, fmt::format("the {} of the box", name),
        "bodies start within the walls: move them, or the box's sides");
  }

  /// Warns of nodes at a wall of contact that $in holds there.
  void check_held(int k, const GridEdge& edge) {
    const std::size_t held = edge.wall == Wall::open ? 0 : nodes_at(solids_.mesh, edge).size();
    if (held == 0) return;
    warn("contact.wall", {k, 1},
         fmt::format("{} of $in holds {} nodes that start at the {}: they never leave it", edge.variable, held,
                     deck_.text("contact.wall", k)),
         fmt::format("write {}=1 in $in", edge.variable));
  }

  void add_plane(int k) {
    if (!is_whole("contact.plane", k, "a plane has x and y of a place and of its normal",
                  "a plane in space has x, y and z of a place and of its normal"))
      return;
    SurfacePlane plane;
    for (int i = 0; i < dim_; ++i) {
      plane.place[at(i)] = deck_.real("contact.plane", i + 1, k);
      plane.normal[at(i)] = deck_.real("contact.plane", dim_ + i + 1, k);
    }
    const double length = std::hypot(plane.normal[0], plane.normal[1], plane.normal[2]);
    if (!(length > 0) || !std::isfinite(length))
      return error("contact.plane", {dim_ + 1, k}, fmt::format("plane {} has a normal of length {:.6g}", k, length),
                   "the normal points to where the bodies are, with any length above 0");
    for (double& n : plane.normal) n /= length;
    add(plane, "contact.plane", {1, k}, fmt::format("plane {}", k), "the normal points to where the bodies are");
  }

  void add_obstacle(int k) {
    constexpr const char* hint = "a box has a lowest and a highest place along each axis";
    if (!is_whole("contact.obstacle", k, hint, hint)) return;
    Box<3> box;
    for (int i = 0; i < dim_; ++i) {
      const double low = deck_.real("contact.obstacle", 2 * i + 1, k);
      const double high = deck_.real("contact.obstacle", 2 * i + 2, k);
      if (!(high > low))
        return error("contact.obstacle", {2 * i + 2, k},
                     fmt::format("obstacle {}: {:.6g} is not above {:.6g}", k, high, low),
                     "the lowest place first, along x, y, z");
      box.low[at(i)] = low, box.high[at(i)] = high;
    }
    check_start([&](const Vec<3>& x) { return depth_in(box, x, dim_); }, "contact.obstacle", {1, k},
                fmt::format("within obstacle {}", k), "bodies start out of obstacles");
    contact_.obstacles.push_back(box);
  }

  /// Returns whether the deck gives all two numbers an axis of plane or obstacle k, and no more of them.
  bool is_whole(AnyVariable name, int k, const char* in_plane, const char* in_space) {
    for (int i = 1; i <= 2 * dim_; ++i) {
      if (deck_.given(name, i, k)) continue;
      int given = 1;
      while (!deck_.given(name, given, k)) ++given;
      error(name, {given, k}, fmt::format("{0} {1}: {0}({2},{1}) is not given", name, k, i),
            dim_ == 3 ? in_space : in_plane);
      return false;
    }
    for (int i = 2 * dim_ + 1; i <= 6; ++i) {
      if (!deck_.given(name, i, k)) continue;
      error(name, {i, k}, fmt::format("{} {} has more than four numbers, but the mesh is plane", name, k),
            fmt::format("{}; with z of the regions in $mesh there are bodies in space", in_plane));
      return false;
    }
    return true;
  }

  void add(const SurfacePlane& plane, AnyVariable name, Subscript at, const std::string& what, const char* hint) {
    check_start([&](const Vec<3>& x) { return dot(plane.normal, minus(plane.place, x)); }, name, at, "beyond " + what,
                hint);
    contact_.planes.push_back(plane);
  }

  /// Reports the node that starts deepest where bodies do not go, if one does; depth is by a place [length].
  template <class Depth>
  void check_start(const Depth& depth, AnyVariable name, Subscript at, const std::string& where, const char* hint) {
    double most = rounding_;
    int deepest = -1;
    for (const int node : meeting_) {
      const double deep = depth(place_of(solids_.mesh.x, node, dim_));
      if (deep > most) most = deep, deepest = node;
    }
    if (deepest < 0) return;
    error(name, at,
          fmt::format("{}: its node {} at {} starts {:.3g} {}", region_with(deepest), deepest + 1,
                      place_text(solids_.mesh, deepest), most, where),
          hint);
  }

  const std::string& region_with(int node) const {
    const auto first =
        static_cast<std::size_t>(std::ranges::find(solids_.mesh.nodes, node) - solids_.mesh.nodes.begin());
    const std::size_t element = first / at(node_count_of(solids_.mesh.kind));
    return solids_.regions[at(solids_.mesh.region[element])].name;
  }

  void check_integrator() {
    if (solids_.integrator == Integrator::energy || solids_.integrator == Integrator::equilibrium) return;
    error("fem.integrator", {1, 1},
          fmt::format("there is no contact in steps by integrator='{}'", deck_.text("fem.integrator")),
          "leave integrator away, or write integrator='energy'");
  }

  /// Reports a deck that leaves nothing to meet.
  void check_anything_meets() {
    if (contact_.bodies || contact_.itself || !walls_.empty()) return;
    for (const AnyVariable name : Variables{"contact.wall", "contact.plane", "contact.obstacle"}) {
      if (!deck_.given_elements(name).empty()) return;
    }
    error("contact.itself", {1, 1},
          "bodies have nothing to meet: bodies and itself are .false., and there is no wall, plane or obstacle",
          "leave bodies or itself away, or name a wall");
  }

  const Deck& deck_;
  const Scene& scene_;
  const Solids& solids_;
  Diagnostics& diagnostics_;
  int dim_;
  std::vector<int> meeting_;  // nodes of the surface that can meet something, ascending
  double rounding_;           // [length]
  std::set<int> walls_;       // sides of the box that are walls
  Contact contact_;
};

}  // namespace

void check_contact_deck(const Deck& deck, Diagnostics& diagnostics) {
  if (!deck.has_group("contact")) return;
  const auto no = [&](const char* message, const char* hint) {
    diagnostics.add(deck.remark_on_group(Severity::error, "contact", message, hint));
  };
  if (has_flow(deck) && deck.logical("flow.steady"))
    return no("bodies in steady flows do not meet", "leave $contact away, or steady");
  if (deck.has_group("rigid"))
    return no("a rigid body meets nothing: $contact is of elastic bodies", "leave $contact away, or $rigid");
  if (has_flow(deck) && regions_of(deck, false).empty())
    return no("$contact has no bodies to act on: every region is fluid", "leave $contact away, or add a body");
  if (!deck.has_group("mesh"))
    no("$contact has no bodies to act on: the deck has no $mesh",
       "add $mesh, whose cells(1,r) divide region r of $reg; contact of $mpm is that of material points");
}

Contact read_contact(const Deck& deck, const Scene& scene, const Solids& solids, const std::set<int>& walls,
                     Diagnostics& diagnostics) {
  return ContactReader(deck, scene, solids, walls, diagnostics).read();
}

std::optional<Contact> contact_of(const Deck& deck, const Scene& scene, const Solids& solids,
                                  Diagnostics& diagnostics) {
  const bool meets =
      std::holds_alternative<ElasticBodies>(scene.physics) || std::holds_alternative<MeshFlow>(scene.physics);
  if (!deck.has_group("contact") || !meets) return std::nullopt;
  Contact contact = read_contact(deck, scene, solids, {}, diagnostics);
  check_contact(deck, solids, contact, diagnostics);
  return contact;
}

}  // namespace tether
