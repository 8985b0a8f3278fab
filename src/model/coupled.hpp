// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/vec.hpp"
#include "base/words.hpp"
#include "grid/boxes.hpp"
#include "grid/figures.hpp"
#include "model/flow.hpp"
#include "model/liquid.hpp"
#include "model/solids.hpp"

namespace tether {

/// The modes in which fluid and solids are solved; `couplings` says what each does.
enum class CouplingMode { symmetric, cut_cell, splitting, paper };
template <>
inline constexpr std::array<Word<CouplingMode>, 4> words<CouplingMode>{{{CouplingMode::cut_cell, "cut-cell"},
                                                                        {CouplingMode::symmetric, "symmetric"},
                                                                        {CouplingMode::splitting, "splitting"},
                                                                        {CouplingMode::paper, "paper"}}};

/// What a mode of coupling does: the one place where modes differ.
struct Coupling {
  CouplingMode mode;
  bool cuts_faces;    ///< faces are open in part where bodies cut them; else cells are wholly fluid or not
  bool simultaneous;  ///< fluid and solids in one system; else one after the other
  bool two_maps;      ///< the solids' motion displaces fluid by a map that is not the transpose of the pressures'
  std::string_view meaning;  ///< for the plan
  /// Returns whether one system has one map and its transpose, so that the solids take what the fluid gives.
  constexpr bool balances_power() const { return simultaneous && !two_maps; }
};
inline constexpr std::array couplings{
    Coupling{.mode = CouplingMode::symmetric,
             .cuts_faces = false,
             .simultaneous = true,
             .two_maps = false,
             .meaning = "simultaneous, power across the interface balances to rounding"},
    Coupling{.mode = CouplingMode::cut_cell,
             .cuts_faces = true,
             .simultaneous = true,
             .two_maps = false,
             .meaning = "simultaneous, with the open parts of faces; power balances to rounding"},
    Coupling{.mode = CouplingMode::splitting,
             .cuts_faces = false,
             .simultaneous = false,
             .two_maps = false,
             .meaning = "solids and fluid one after the other"},
    Coupling{.mode = CouplingMode::paper,
             .cuts_faces = false,
             .simultaneous = true,
             .two_maps = true,
             .meaning = "simultaneous by two maps, whose powers differ; would take cut-cell"},
};
/// The row of a mode. Throws std::logic_error where it has none.
constexpr const Coupling& coupling_of(CouplingMode mode) {
  for (const Coupling& coupling : couplings) {
    if (coupling.mode == mode) return coupling;
  }
  throw std::logic_error("a mode of coupling without a row");
}
static_assert(
    [] {
      for (const auto& word : words<CouplingMode>) static_cast<void>(coupling_of(word.value));
      return true;
    }(),
    "each mode has its row");

/// The step of the solids: the paper's, of order 1 in the velocity, or the trapezoidal rule.
enum class CoupledIntegrator { paper, trapezoid };
template <>
inline constexpr std::array<Word<CoupledIntegrator>, 2> words<CoupledIntegrator>{
    {{CoupledIntegrator::paper, "paper"}, {CoupledIntegrator::trapezoid, "trapezoid"}}};

/// How a step finds where solids go: by one linear solution, with the stiffness of the step's start; by Newton's
/// method, with forces that keep the energy; or as the scene asks.
enum class SolidsStep { automatic, linear, energy };
template <>
inline constexpr std::array<Word<SolidsStep>, 3> words<SolidsStep>{
    {{SolidsStep::automatic, "auto"}, {SolidsStep::linear, "linear"}, {SolidsStep::energy, "energy"}}};

/// How a flow carries its velocity along.
enum class Advection { semi_lagrangian, maccormack };
template <>
inline constexpr std::array<Word<Advection>, 2> words<Advection>{
    {{Advection::semi_lagrangian, "semi-lagrangian"}, {Advection::maccormack, "maccormack"}}};

/// What the fluid's cells are: those of the grid, or triangles and tetrahedra that fit the solids.
enum class FlowCells { grid, mesh };
template <>
inline constexpr std::array<Word<FlowCells>, 2> words<FlowCells>{
    {{FlowCells::grid, "grid"}, {FlowCells::mesh, "mesh"}}};

/// How long the edges of a fluid's triangles are.
struct MeshSizes {
  double size = 1;      ///< far from solids, obstacles and jets [length]
  double near = 1;      ///< most at these [length]
  double growth = 0.3;  ///< by how much they may grow from the surface on, over the way
};

/// What a side of the box is: a wall, which a viscous fluid sticks to; a wall that any fluid slips along; open to fluid
/// at rest, whose pressure grows with the depth; or open with nothing beyond, where the pressure is zero.
enum class BoxSide { wall, slip, open, empty };
template <>
inline constexpr std::array<Word<BoxSide>, 4> words<BoxSide>{
    {{BoxSide::wall, "wall"}, {BoxSide::slip, "slip"}, {BoxSide::open, "open"}, {BoxSide::empty, "void"}}};

inline bool is_wall(BoxSide side) { return side == BoxSide::wall || side == BoxSide::slip; }

/// Numbers of the sides of a box.
enum BoxSideNumber { side_left, side_right, side_bottom, side_top, side_back, side_front };
constexpr std::array<const char*, 6> box_side_names{"left", "right", "bottom", "top", "back", "front"};

/// Returns what the cells whose middles lie in a box make of it. In the plane its z is that of the grid's layer of
/// cells.
Box<3> cells_of(const Box<3>& box, const StaggeredGrid& grid);

/// The axis across a side of the box, and whether the side is at its lower end.
constexpr int axis_of_side(int side) { return side / 2; }
constexpr bool is_low_side(int side) { return side % 2 == 0; }

/// Part of a side that is open.
struct Opening {
  int side = side_left;
  Box<3> patch;    ///< as a jet's
  int number = 0;  ///< of the deck's opening, from 1
};

/// Part of a side that fluid is blown in through.
struct Jet {
  int side = side_left;
  Box<3> patch;            ///< its part of the side; along the side's own axis both ends are the side's place
  double speed = 0;        ///< into the box [velocity]
  Amplitude amplitude;     ///< factor of the speed
  double smoke = 0;        ///< density of what comes in
  double temperature = 0;  ///< above that of the surroundings
  int number = 0;          ///< of the deck's jet, from 1
};

/// A figure at rest that cuts the cells at its surface.
struct Obstacle {
  Figure figure;
  int number = 0;  ///< of the deck's obstacle, from 1
};

/// Smoke that a box holds at the start; where boxes overlap their smoke adds up, and a cell that lies in one in part
/// has that part of it.
struct SmokeBox {
  Box<3> box;
  double density = 0, temperature = 0;
};

/// Nodes that a spring pulls back to where they were at the start: each in proportion to its mass, so that a stiff body
/// moves as a whole.
struct Spring {
  std::vector<int> nodes;
  Vec<3> stiffness{};  ///< of all together [force/length]
  int number = 0;
};

/// An incompressible fluid in a box, with deformable solids in it (the scene's solids, where there are any), as the
/// deck's groups $in and $coupled describe it.
struct Coupled {
  StaggeredGrid grid;
  Coupling coupling = coupling_of(CouplingMode::cut_cell);
  SolidsStep step = SolidsStep::automatic;
  CoupledIntegrator integrator = CoupledIntegrator::paper;  ///< of linear steps
  Advection advection = Advection::maccormack;
  Systems systems = Systems::automatic;
  double tolerance = 1e-12;  ///< of conjugate gradients and BiCGSTAB: residual over the right side
  double density = 1;        ///< of the fluid [mass/volume]
  double viscosity = 0;      ///< mu [stress time]
  bool bodies_slip = true;   ///< whether a viscous fluid slips along bodies
  std::array<BoxSide, 6> sides{};
  double gravity_x = 0;  ///< acceleration along x, of fluid and solids; that along y is the scene's
  double level = 0;      ///< height at which the fluid beyond open sides has no pressure [length]
  std::vector<Opening> openings;
  std::vector<Jet> jets;
  std::vector<Box<3>> obstacles;  ///< at rest, that fluid and solids do not enter
  std::vector<Obstacle> shaped;   ///< likewise, which cut cells
  std::vector<Box<3>> voids;      ///< whose cells hold no fluid: pressure zero
  bool cavities_only = false;     ///< fluid only where solids enclose it, void around them
  Vec<3> start{};                 ///< velocity of the fluid at the start
  std::optional<MeshSizes> mesh;  ///< where the fluid's cells are triangles
  std::optional<Liquid> liquid;   ///< where the fluid has a surface
  bool smoke = false;             ///< whether density and temperature of smoke are carried along
  std::vector<SmokeBox> smoke_boxes;
  double smoke_weight = 0;  ///< acceleration downwards by a density of 1 [acceleration]
  double smoke_lift = 0;    ///< acceleration upwards by a temperature of 1 [acceleration]
  bool contact = true;      ///< of solids with walls and obstacles
  double friction = 0;      ///< Coulomb's coefficient of it
  bool volume_term = true;  ///< whether volumes of closed regions are held
  bool area_repair = true;  ///< of splitting: whether wall velocities of closed regions are balanced
  bool convex = true;       ///< whether K' is made positive semi-definite
  std::vector<Spring> springs;
};

/// Returns whether an obstacle of any kind has a place.
bool in_obstacle(const Coupled& coupled, const Vec<3>& x);

struct Scene;
/// Returns the acceleration of fluid and solids of a scene that is coupled [acceleration].
Vec<3> gravity_of(const Scene& scene);

/// Returns whether the fluid rubs at bodies.
inline bool sticks_to_bodies(const Coupled& coupled) { return coupled.viscosity > 0 && !coupled.bodies_slip; }

/// Returns whether steps of a length keep the energy of the solids, as `step` says: where it leaves that open, those of
/// solids that meet do, and of solids that linear steps would give much energy [tstep: time].
bool keeps_energy(const Coupled& coupled, const Solids& solids, double tstep);
/// Returns the share of the energy of its turning that a linear step gives a region which turns at a rate [1/time]:
/// it is stretched by half the square of the angle that it turns by, and has the energy of that. `radius` is that of
/// gyration [length].
double linear_gain(const SolidRegion& region, double rate, double radius, double tstep);
/// Returns the largest of these at the start.
double linear_gain(const Solids& solids, double tstep);
/// Above this share linear steps are not taken unless the deck says so.
constexpr double most_linear_gain = 0.01;

/// Returns whether there is fluid beyond a side: it is open, or a wall with an opening.
bool has_fluid_beyond(const Coupled& coupled, int side);

/// In space more cells than these are solved by conjugate gradients where the deck leaves it open.
constexpr double most_cells_of_factors = 2e3;
/// Which of direct and krylov is taken.
Systems systems_of(const Coupled& coupled);

/// A part of a face's area that a jet has.
struct JetShare {
  int jet = 0;      ///< its place among the scene's
  double part = 0;  ///< of the face's area
};

/// A face of the grid in a patch of a side, and how much of its area lies there.
struct FacePart {
  std::size_t face = 0;
  double part = 0;
};

/// The faces, of those across the side's axis, that a patch of a side reaches into, in ascending order.
std::vector<FacePart> faces_of(int side, const Box<3>& patch, const StaggeredGrid& grid);
/// The cell that a face of a side belongs to.
std::size_t cell_at(int side, const StaggeredGrid& grid, std::size_t face);

/// What the faces in the box's sides are, by the parts of their areas, so that what goes through jets and openings is
/// the deck's whatever the grid. Of two jets at one place the later one has it, and a jet has it before an opening. The
/// velocity of a face that has a part of a jet is prescribed: what else of it is open stays closed.
class SideFaces {
 public:
  explicit SideFaces(const Coupled& coupled);

  /// The jets that have a part of a face; none for faces within the box.
  std::span<const JetShare> jets(int axis, std::size_t face) const {
    const int k = number_[static_cast<std::size_t>(axis)][face];
    return k < 0 ? std::span<const JetShare>() : faces_[static_cast<std::size_t>(k)].jets;
  }
  /// How much of a face in a side is open.
  double open(int axis, std::size_t face) const {
    const int k = number_[static_cast<std::size_t>(axis)][face];
    return k < 0 ? 0 : faces_[static_cast<std::size_t>(k)].open;
  }

 private:
  struct Face {
    std::vector<JetShare> jets;
    double open = 0;
  };
  void add_side(const Coupled& coupled, int side);

  std::array<std::vector<int>, 3> number_;  // of each face, -1 within the box
  std::vector<Face> faces_;
};

}  // namespace tether
