// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/build.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "read/bodies.hpp"
#include "read/box/box.hpp"
#include "read/edges.hpp"
#include "read/flow/flow.hpp"
#include "read/limits.hpp"
#include "read/mesh/contact.hpp"
#include "read/mesh/fem_checks.hpp"
#include "read/mesh/solids.hpp"
#include "read/method.hpp"
#include "read/points/geometry.hpp"
#include "read/points/membranes.hpp"
#include "read/points/region_checks.hpp"
#include "read/points/strip.hpp"
#include "read/reference/reference.hpp"
#include "read/values.hpp"

namespace tether {
namespace {

std::string title_of(const Deck& deck) {
  std::string title;
  for (const auto& line : deck.header()) title += (title.empty() ? "" : "\n") + line;
  return title;
}

Walls walls_of(const Deck& deck) {
  const auto wall = [&](IntegerVariable name) { return find_word<Wall>(std::to_string(deck.integer(name))).value(); };
  return {wall("in.wl"), wall("in.wr"), wall("in.wb"), wall("in.wt")};
}

/// Of the coupled path, where sides of the box stop bodies by contact and hold none.
constexpr Walls open_walls{Wall::open, Wall::open, Wall::open, Wall::open};

Clock clock_of(const Deck& deck, Path path, Diagnostics& diagnostics) {
  const double tstep = deck.real("in.tstep");
  const double dtmax = deck.given("in.dtmax") ? deck.real("in.dtmax") : tstep;
  if (tstep > dtmax) {
    diagnostics.add(
        deck.remark(Severity::warning, "in.tstep", {1, 1},
                    fmt::format("tstep = {:.6g} is above dtmax = {:.6g}: steps are no longer than dtmax", tstep, dtmax),
                    "write dtmax, too"));
  }
  const double cfl = path == Path::coupled ? 0 : path == Path::fem ? deck.real("fem.cfl") : cfl_of(deck);
  return {deck.real("in.tmax"), std::min(tstep, dtmax), cfl};
}

/// Returns whether nodes from low to high differ in floating point, and 1/dx too.
bool resolvable(double low, double high, int nodes) {
  const double size = (high - low) / (nodes - 1);
  return std::isfinite(size) && std::isfinite(1 / size) && low + size > low && high - size < high;
}

/// Returns whether the grid can be made; reports where not.
bool check_axes(const Deck& deck, Diagnostics& diagnostics) {
  const auto ordered = [&](RealVariable low, RealVariable high, IntegerVariable nodes) {
    const double a = deck.real(low), b = deck.real(high);
    if (b > a && resolvable(a, b, deck.integer(nodes))) return true;
    const char* what = b > a ? "so close to" : "not above";
    diagnostics.add(deck.remark(Severity::error, high, {1, 1},
                                fmt::format("{} = {:.6g} is {} {} = {:.6g}", high, b, what, low, a),
                                "the nodes would coincide"));
    return false;
  };
  const bool x = ordered("in.xleft", "in.xright", "in.nx"), y = ordered("in.ybot", "in.ytop", "in.ny");
  return x && y;
}

/// Returns whether the memory holds grid and particle file; reports where not.
bool check_memory(const Deck& deck, const BackgroundGrid& grid, std::size_t rows, Diagnostics& diagnostics) {
  const std::string too_large = memory_refusal(grid, static_cast<double>(rows));
  if (too_large.empty()) return true;
  diagnostics.add(deck.remark(Severity::error, "in.nx", {1, 1}, too_large, "use fewer nodes"));
  return false;
}

void add_bodies(const Deck& deck, const std::optional<ParticleFile>& particles, Scene& scene,
                Diagnostics& diagnostics) {
  const int igen = deck.integer("in.igen");
  if (igen != 0) {
    for (const int r : regions_of(deck)) add_region(deck, r, scene, diagnostics);
  }
  const std::size_t file_first = scene.points.size();
  const std::size_t file_body = scene.bodies.size();
  if (particles) add_file_body(deck, *particles, scene, diagnostics);
  const std::size_t file_rows = scene.points.size() - file_first;
  add_membranes(deck, scene, diagnostics);
  check_regions(deck, scene, diagnostics);
  if (igen != 1 && file_rows == 0 && diagnostics.has_errors()) return;  // rows of a file that could not be read
  apply_points_group(deck, file_first, file_rows, scene, diagnostics);
  if (file_rows > 0 && !diagnostics.has_errors() &&
      std::holds_alternative<Membrane>(scene.bodies[file_body].material)) {
    tell_file_gaps(*particles, scene.bodies[file_body], scene, diagnostics);
  }
  if (scene.points.size() == 0 && !diagnostics.has_errors()) {
    diagnostics.add(deck.remark(Severity::error, "in.igen", {1, 1}, "the deck describes no point",
                                "igen 0 reads a particle file, 1 the regions of $reg, 3 both"));
  }
}

/// The pressure around membranes, which without one acts on nothing.
double ambient_of(const Deck& deck, const Scene& scene, Diagnostics& diagnostics) {
  const double pressure = deck.real("fluid.pambient");
  if (pressure != 0 && !find_body<Membrane>(scene) && !diagnostics.has_errors()) {
    diagnostics.add(deck.remark(Severity::warning, "fluid.pambient", {1, 1},
                                fmt::format("pambient = {:.6g} has no effect: there is no membrane", pressure)));
  }
  return pressure;
}

/// Notes that gas does not stay at rest by linear shape functions over several cells both ways: what rounding leaves
/// grows by about 0.6 c/dx, to some per cent of the pressure after 60 dx/c (measured in a closed box).
void note_restless_gas(const Deck& deck, const Scene& scene, Diagnostics& diagnostics) {
  if (scene.method.kernel != Kernel::linear || scene.grid.cells_x() < 2 || scene.grid.cells_y() < 2) return;
  double fastest = 0;
  for (const Body& body : scene.bodies) {
    if (const auto* gas = std::get_if<IdealGas>(&body.material))
      fastest = std::max(fastest, std::sqrt(gas->sound_speed_squared(body.specific_energy)));
  }
  const double restless = 60 * std::min(scene.grid.dx, scene.grid.dy) / fastest;
  if (!(restless < scene.clock.tmax) || diagnostics.has_errors()) return;
  diagnostics.add(deck.remark(
      Severity::remark, "mpm.kernel", {1, 1},
      fmt::format(
          "gas by linear shape functions does not stay at rest over several cells both ways: from about t = {:.3g}, "
          "60 dx/c, on its pressures may be off by some per cent of themselves",
          restless),
      "kernel='bspline' or method='robust' of $mpm keeps gas at rest"));
}

/// Checks membranes by curves, in a grid so large that no place in it is wrong; what that grid makes doubtful does not
/// count.
void check_curves(const Deck& deck, const Method& method, Diagnostics& diagnostics) {
  constexpr double far = 1e30;
  Scene scene;
  scene.grid = BackgroundGrid(2, 2, -far, far, -far, far);
  scene.geometry = geometry_of(deck);
  scene.method = method;
  Diagnostics found;
  add_membranes(deck, scene, found);
  for (auto& error : found.errors()) diagnostics.add(std::move(error));
}

/// Regions that $fem is to divide, where nothing says how; strings alone become bars.
bool lacks_mesh(const Deck& deck) {
  if (!deck.has_group("fem") || deck.integer("in.igen") == 0) return false;
  for (const AnyVariable name : Variables{"fem.law", "fem.fix_on", "fem.load_on", "fem.static"}) {
    if (!deck.given_elements(name).empty()) return !regions_of(deck).empty();
  }
  return false;
}

/// Returns what the deck's groups and the path ask for, still empty.
Physics physics_of(const Deck& deck, Path path) {
  if (path == Path::coupled) return BoxFlow{};
  if (has_flow(deck)) return MeshFlow{};
  if (deck.has_group("rigid")) return RigidBody{};
  if (deck.has_group("mesh")) return ElasticBodies{};
  if (path == Path::fem) return Bars{};
  return MaterialPoints{};
}

}  // namespace

void check_without_grid(const Deck& deck, Diagnostics& diagnostics) {
  if (deck.is_study()) return;
  limits_of(deck, nullptr, diagnostics);
  const Method method = method_of(deck, diagnostics);
  const bool of_points =
      !deck.has_group("mesh") && !deck.has_group("rigid") && !deck.has_group("coupled") && !has_flow(deck);
  if (!of_points) return;
  if (deck.given("in.xleft")) check_axis(deck, diagnostics);
  Walls walls = walls_of(deck);
  edges_of(deck, walls, diagnostics);
  check_curves(deck, method, diagnostics);
  if (deck.integer("in.igen") == 0) return;
  for (const int r : regions_of(deck)) check_region(deck, r, diagnostics);
}

Scene build_scene(const Deck& deck, const std::optional<ParticleFile>& particles, Path path, Diagnostics& diagnostics) {
  Scene scene;
  scene.physics = physics_of(deck, path);
  check_contact_deck(deck, diagnostics);
  check_axis(deck, diagnostics);
  if (!check_axes(deck, diagnostics)) {
    check_without_grid(deck, diagnostics);
    return scene;
  }
  scene.title = title_of(deck);
  scene.units = word<Units>(deck, "in.units");
  scene.grid = BackgroundGrid(deck.integer("in.nx"), deck.integer("in.ny"), deck.real("in.xleft"),
                              deck.real("in.xright"), deck.real("in.ybot"), deck.real("in.ytop"));
  if (!check_memory(deck, scene.grid, particles ? particles->rows.size() : 0, diagnostics)) return scene;
  scene.geometry = geometry_of(deck);
  scene.walls = path == Path::coupled ? open_walls : walls_of(deck);
  if (path == Path::mpm) scene.edges = edges_of(deck, scene.walls, diagnostics);
  scene.gravity = deck.real("in.gravc");
  scene.clock = clock_of(deck, path, diagnostics);
  scene.method = method_of(deck, diagnostics);
  if (path == Path::fem) scene.method.membrane_strain = MembraneStrain::element;  // bars, whose nodes a pin holds
  if (path == Path::coupled) {
    add_coupled(deck, scene, diagnostics);
  } else if (has_flow(deck)) {
    add_flow(deck, scene, diagnostics);
  } else if (deck.has_group("mesh") || deck.has_group("rigid")) {
    add_solids(deck, scene, diagnostics);
  } else if (lacks_mesh(deck)) {
    diagnostics.add(
        deck.remark_on_group(Severity::error, "fem", "$fem has no mesh to act on",
                             "add $mesh, whose cells(1,r) divide region r of $reg, or whose file names a mesh; "
                             "without $fem the regions are of material points"));
  } else {
    add_bodies(deck, particles, scene, diagnostics);
    check_edges(deck, scene, diagnostics);
    if (path == Path::mpm) note_restless_gas(deck, scene, diagnostics), read_strip(deck, scene, diagnostics);
    if (path == Path::fem) check_fem(deck, particles, scene, diagnostics);
  }
  scene.ambient = ambient_of(deck, scene, diagnostics);
  scene.limits = limits_of(deck, scene.solids(), diagnostics);
  scene.outputs = outputs_of(deck, scene, diagnostics);
  drop_grid_outputs(deck, scene, diagnostics);
  scene.reference = reference_of(deck, scene, diagnostics);
  scene.reference_window = reference_window_of(deck, scene, diagnostics);
  return scene;
}

}  // namespace tether
