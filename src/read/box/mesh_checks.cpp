// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "read/box/checks.hpp"
#include "read/values.hpp"

namespace tether {
namespace {

#ifdef TETHER_TETGEN
constexpr bool makes_tetrahedra = true;
#else
constexpr bool makes_tetrahedra = false;
#endif

/// Reports what a flow on a mesh cannot have in its box.
class FlowMeshChecks {
 public:
  FlowMeshChecks(const Deck& deck, const Coupled& coupled, Diagnostics& diagnostics)
      : deck_(deck), coupled_(coupled), diagnostics_(diagnostics) {}

  /// Says what has no effect on a grid.
  void without() {
    for (const AnyVariable name : Variables{"coupled.size", "coupled.size_near", "coupled.growth"}) {
      if (deck_.given(name) && !is_default(deck_, name, {1, 1}))
        error(name, fmt::format("{} has no effect: the fluid's cells are the grid's", name.name()),
              "flow='mesh' makes cells that fit the bodies; nx and ny of $in are those of the grid");
    }
  }

  void all() {
    if (coupled_.grid.dim == 3 && !makes_tetrahedra)
      error("coupled.flow", "this build makes no tetrahedra: it was made without TetGen",
            "install libtet1.5-dev and build anew, or leave flow away");
    if (coupled_.grid.dim == 3) check_obstacles();
    if (coupled_.liquid)
      error("coupled.flow", "the surface of a liquid is found on the grid: its particles and hats need square cells",
            "leave flow away");
    if (!coupled_.voids.empty())
      error("coupled.flow", "a mesh of the fluid leaves no boxes empty",
            "leave void away, or flow; fluid_in='cavities' leaves all empty but cavities");
    if (coupled_.mesh->near > coupled_.mesh->size)
      error("coupled.size_near", fmt::format("size_near is larger than size, {:.6g}", coupled_.mesh->size),
            "write a length of at most that");
    if (coupled_.coupling.mode != CouplingMode::cut_cell && coupled_.coupling.simultaneous)
      error("coupled.mode",
            fmt::format("mode='{}' is of the grid: faces of a mesh fit the bodies", word_of(coupled_.coupling.mode)),
            "leave mode away, write mode='splitting', or leave flow away");
    if (deck_.given("coupled.advection") && !is_default(deck_, "coupled.advection", {1, 1}))
      error("coupled.advection", "a mesh carries the velocity over from the one before, in its own way",
            "leave advection away, or flow");
    if (coupled_.systems == Systems::krylov && coupled_.grid.dim == 2)
      error("coupled.solver", "the pressures of triangles are solved by factors", "leave solver away");
  }

 private:
  /// In space those that are no boxes must lie within the box.
  void check_obstacles() {
    std::vector<const Obstacle*> before;
    for (const Obstacle& obstacle : coupled_.shaped) {
      const auto* round = std::get_if<Ellipsoid>(&obstacle.figure);
      bool within = round != nullptr;
      for (std::size_t a = 0; within && a < 3; ++a)
        within = round->half[a] > 0 && round->middle[a] - 1.05 * round->half[a] > coupled_.grid.low[a] &&
                 round->middle[a] + 1.05 * round->half[a] < coupled_.grid.high(static_cast<int>(a));
      if (!within)
        error(
            "coupled.flow",
            fmt::format("obstacle {} reaches to a side of the box or beyond: in space a mesh has obstacles that are no "
                        "boxes within it, not near to its sides",
                        obstacle.number),
            "write a smaller obstacle_ellipse or obstacle(1:6,k), or leave flow away");
      else
        check_apart(*round, obstacle.number, before);
      if (within) before.push_back(&obstacle);
    }
  }

  /// No mesh is between surfaces that touch. Facets are off the surface by up to a thousandth of a cell.
  void check_apart(Ellipsoid round, int number, const std::vector<const Obstacle*>& before) {
    for (double& half : round.half) half += 2e-3 * coupled_.mesh->near;
    const auto touches = [&](const Obstacle* other) { return meet(round, std::get<Ellipsoid>(other->figure)); };
    const auto touches_box = [&](const Box<3>& box) { return meet(round, box); };
    if (std::ranges::none_of(before, touches) && std::ranges::none_of(coupled_.obstacles, touches_box)) return;
    error("coupled.obstacle_ellipse",
          fmt::format("obstacle {} touches another one, or reaches into it: no mesh in space is between them", number),
          "write obstacles that stand apart, or leave flow away", number);
  }

  void error(const AnyVariable& name, const std::string& message, const std::string& hint, int number = 1) {
    diagnostics_.add(deck_.remark(Severity::error, name, {1, number}, message, hint));
  }

  const Deck& deck_;
  const Coupled& coupled_;
  Diagnostics& diagnostics_;
};

}  // namespace

void check_flow_mesh(const Deck& deck, const Coupled& coupled, Diagnostics& diagnostics) {
  FlowMeshChecks checks(deck, coupled, diagnostics);
  coupled.mesh ? checks.all() : checks.without();
}

}  // namespace tether
