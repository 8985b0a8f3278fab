// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <variant>

#include "base/words.hpp"
#include "grid/elements.hpp"
#include "laws/hyperelastic.hpp"

namespace tether {

// What decks name and only the reading of them asks for: the model has it in another form.

/// The sets of $mpm method.
enum class MpmSet { thesis, robust };
template <>
inline constexpr std::array<Word<MpmSet>, 2> words<MpmSet>{{{MpmSet::thesis, "thesis"}, {MpmSet::robust, "robust"}}};

/// Whose coefficients the artificial viscosity of a gas has.
enum class ViscosityOf { deck, local };
template <>
inline constexpr std::array<Word<ViscosityOf>, 2> words<ViscosityOf>{
    {{ViscosityOf::deck, "deck"}, {ViscosityOf::local, "local"}}};

/// A curve of a membrane.
enum class CurveKind { line, polyline, arc, ellipse, spline };
template <>
inline constexpr std::array<Word<CurveKind>, 5> words<CurveKind>{{{CurveKind::line, "line"},
                                                                  {CurveKind::polyline, "polyline"},
                                                                  {CurveKind::arc, "arc"},
                                                                  {CurveKind::ellipse, "ellipse"},
                                                                  {CurveKind::spline, "spline"}}};

/// Ends of a membrane that a pin holds.
enum class PinnedEnds { none, first, last, both };
template <>
inline constexpr std::array<Word<PinnedEnds>, 4> words<PinnedEnds>{
    {{PinnedEnds::none, "none"}, {PinnedEnds::first, "first"}, {PinnedEnds::last, "last"}, {PinnedEnds::both, "both"}}};

/// An edge of a region that is divided into elements.
enum class MeshEdge { line, arc, ellipse };
template <>
inline constexpr std::array<Word<MeshEdge>, 3> words<MeshEdge>{
    {{MeshEdge::line, "line"}, {MeshEdge::arc, "arc"}, {MeshEdge::ellipse, "ellipse"}}};

/// Names of elements of bodies, each in the plane and in space.
struct BodyElements {
  static constexpr std::size_t count =
      std::ranges::count_if(element_rows, [](const ElementRow& row) { return row.dim == 2; });
  static constexpr auto texts = [] {
    std::array<std::string_view, count> names;
    std::size_t k = 0;
    for (const ElementRow& row : element_rows) {
      if (row.dim == 2) names[k++] = row.name;
    }
    return names;
  }();
};
inline constexpr std::string_view body_elements = Joined<BodyElements>::text;

/// The word of a region that is a fluid, where others have that of an elastic law.
inline constexpr std::string_view fluid_word = "fluid";

/// Words of laws, and what else stands there.
template <class... Laws>
struct LawsAndFluid {
  static constexpr std::array<std::string_view, sizeof...(Laws) + 1> texts{Laws::word..., fluid_word};
};
template <class... Laws>
constexpr LawsAndFluid<Laws...> laws_and_fluid(std::variant<Laws...>*);
template <class... Laws>
struct LinearAnd {
  static constexpr std::array<std::string_view, sizeof...(Laws) + 1> texts{LinearElastic::word, Laws::word...};
};
template <class... Laws>
constexpr LinearAnd<Laws...> linear_and(std::variant<Laws...>*);

/// Laws that a region of a mesh may have, and those that points may have, too.
inline constexpr std::string_view mesh_laws = Joined<decltype(laws_and_fluid(static_cast<ElasticLaw*>(nullptr)))>::text;
inline constexpr std::string_view point_laws = Joined<decltype(linear_and(static_cast<PointLaw*>(nullptr)))>::text;

/// What is outside of the open sides of a flow on a mesh.
enum class FlowOutside { fluid, nothing };
template <>
inline constexpr std::array<Word<FlowOutside>, 2> words<FlowOutside>{
    {{FlowOutside::fluid, "fluid"}, {FlowOutside::nothing, "void"}}};

/// Whose law keeps the volume of a body in a flow on a mesh.
enum class VolumeOf { own, fluid };
template <>
inline constexpr std::array<Word<VolumeOf>, 2> words<VolumeOf>{{{VolumeOf::own, "own"}, {VolumeOf::fluid, "fluid"}}};

/// Where the fluid of a box is.
enum class FluidIn { box, cavities };
template <>
inline constexpr std::array<Word<FluidIn>, 2> words<FluidIn>{{{FluidIn::box, "box"}, {FluidIn::cavities, "cavities"}}};

}  // namespace tether
