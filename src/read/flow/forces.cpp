// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <utility>

#include "base/text.hpp"
#include "grid/mesh.hpp"
#include "read/flow/flow.hpp"
#include "read/mesh/sides.hpp"

namespace tether {
namespace {

using Ends = std::set<std::pair<int, int>>;

Ends ends_of(const Mesh& mesh, const Sides& sides) {
  const auto per_side = static_cast<std::size_t>(side_node_count_of(mesh.kind));
  Ends ends;
  for (std::size_t s = 0; s < sides.size(); s += per_side) ends.insert(std::minmax(sides[s], sides[s + per_side - 1]));
  return ends;
}

/// Returns whether all of these sides are of the mesh's boundary.
bool on_boundary(const Mesh& mesh, const Sides& sides) {
  const Ends boundary = ends_of(mesh, boundary_of(mesh)), ends = ends_of(mesh, sides);
  return std::includes(boundary.begin(), boundary.end(), ends.begin(), ends.end());
}

/// Reads one force_on(k): names joined by +.
class ForceReader {
 public:
  ForceReader(const Deck& deck, int k, const Mesh& mesh, const Solids* solids, Diagnostics& diagnostics)
      : deck_(deck), k_(k), mesh_(mesh), solids_(solids), diagnostics_(diagnostics) {}

  ForceSide read() {
    force_.name = deck_.text("flow.force_on", k_);
    force_.centre = {deck_.real("flow.force_x", k_), deck_.real("flow.force_y", k_)};
    if (mesh_.sides.contains(force_.name) || body_sides(force_.name)) {
      add(force_.name);
      return force_;
    }
    for (std::size_t from = 0, to = 0; to != std::string::npos; from = to + 1) {
      to = force_.name.find('+', from);
      add(std::string(trim(std::string_view(force_.name).substr(from, to == std::string::npos ? to : to - from))));
    }
    return force_;
  }

 private:
  void refuse(const std::string& message, const std::string& hint) {
    diagnostics_.add(deck_.remark(Severity::error, "flow.force_on", {k_, 1}, message, hint));
  }
  /// A name that both meshes have is the fluid's where it is on the boundary of the fluid.
  void add(const std::string& name) {
    const auto found = mesh_.sides.find(name);
    if (found != mesh_.sides.end() && (!body_sides(name) || on_boundary(mesh_, found->second))) {
      add_sides_of(mesh_, name, found->second, "the fluid's boundary", force_.sides);
    } else if (const auto body = body_named(name)) {
      add_body(name, *body);
    } else if (const Sides* sides = body_sides(name)) {
      add_sides_of(solids_->mesh, name, *sides, "the body's surface", force_.body_sides);
    } else {
      refuse_unknown(name);
    }
  }
  void add_sides_of(const Mesh& mesh, const std::string& name, const Sides& sides, const char* what, Sides& all) {
    if (!on_boundary(mesh, sides))
      return refuse(fmt::format("'{}' is no side of {}: elements join there", name, what),
                    "forces are those on the boundary");
    const Ends before = ends_of(mesh, all), ends = ends_of(mesh, sides);
    if (std::any_of(ends.begin(), ends.end(), [&](const auto& side) { return before.contains(side); }))
      return refuse(fmt::format("'{}' is counted twice", name), "each part of the boundary counts once");
    if (&mesh == &mesh_ || check_apart(name, sides)) all.insert(all.end(), sides.begin(), sides.end());
  }
  /// Returns whether the body that has these sides is not counted itself.
  bool check_apart(const std::string& name, const Sides& sides) {
    for (const int body : force_.bodies) {
      if (!has_any_side(body, sides)) continue;
      refuse(fmt::format("'{}' is counted twice, as a part of 'body {}'", name, body + 1),
             "leave it away, or the body");
      return false;
    }
    return true;
  }
  void add_body(const std::string& name, int body) {
    if (body < 0 || static_cast<std::size_t>(body) >= solids_->regions.size())
      return refuse(
          fmt::format("there is no '{}'", name),
          fmt::format("the bodies are 1 to {}, as the columns body_x_1 .. count them", solids_->regions.size()));
    if (std::ranges::find(force_.bodies, body) != force_.bodies.end() || has_any_side(body, force_.body_sides))
      return refuse(fmt::format("'{}' is counted twice", name), "each body, or part of its surface, counts once");
    force_.bodies.push_back(body);
  }
  /// Returns whether an element of the body has the side from one node to another.
  bool has_side(int body, int first, int last) const {
    const Mesh& mesh = solids_->mesh;
    for (std::size_t e = 0; e < mesh.element_count(); ++e) {
      const std::span nodes(mesh.element(e), static_cast<std::size_t>(node_count_of(mesh.kind)));
      if (mesh.region[e] == body && std::ranges::find(nodes, first) != nodes.end() &&
          std::ranges::find(nodes, last) != nodes.end())
        return true;
    }
    return false;
  }
  bool has_any_side(int body, const Sides& sides) const {
    const auto per_side = static_cast<std::size_t>(side_node_count_of(solids_->mesh.kind));
    for (std::size_t s = 0; s < sides.size(); s += per_side) {
      if (has_side(body, sides[s], sides[s + per_side - 1])) return true;
    }
    return false;
  }
  /// The body, from 0, that 'body 1' names where there are bodies; or none.
  std::optional<int> body_named(const std::string& name) const {
    constexpr std::string_view word = "body ";
    if (!solids_ || !lower(name).starts_with(word)) return std::nullopt;
    const std::string_view number = trim(std::string_view(name).substr(word.size()));
    int body = 0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), body);
    return error == std::errc() && end == number.data() + number.size() ? std::optional(body - 1) : std::nullopt;
  }
  const Sides* body_sides(const std::string& name) const {
    if (!solids_) return nullptr;
    const auto found = solids_->mesh.sides.find(name);
    return found == solids_->mesh.sides.end() ? nullptr : &found->second;
  }
  void refuse_unknown(const std::string& name) {
    std::vector<std::string> names;
    for (const auto& side : mesh_.sides) names.push_back(side.first);
    if (solids_) {
      for (const auto& side : solids_->mesh.sides) names.push_back(side.first);
      for (std::size_t r = 0; r < solids_->regions.size(); ++r) names.push_back(fmt::format("body {}", r + 1));
    }
    const std::string near = nearest_name(name, names), all = fmt::format("{}", fmt::join(names, ", "));
    refuse(fmt::format("no side is called '{}'", name),
           (near.empty() ? std::string() : fmt::format("Did you mean '{}'? ", near)) +
               fmt::format("What has a force: {}; several are joined by +.", all));
  }

  const Deck& deck_;
  int k_;
  const Mesh& mesh_;
  const Solids* solids_;
  Diagnostics& diagnostics_;
  ForceSide force_;
};

}  // namespace

std::vector<ForceSide> force_sides_of(const Deck& deck, const Mesh& mesh, const Solids* solids,
                                      Diagnostics& diagnostics) {
  check_all_act(deck, "force", "flow.force_on", {"flow.force_x", "flow.force_y"}, diagnostics);
  std::vector<ForceSide> forces;
  for (const Subscript at : deck.given_elements("flow.force_on"))
    forces.push_back(ForceReader(deck, at[0], mesh, solids, diagnostics).read());
  return forces;
}

namespace {

/// Reads what of a flow is recorded inside of it.
class ProbeReader {
 public:
  ProbeReader(const Deck& deck, Flow& flow, Diagnostics& diagnostics)
      : deck_(deck), flow_(flow), diagnostics_(diagnostics) {}

  void probes() {
    for (const Subscript at : deck_.given_elements("flow.probe")) {
      const int k = at[1];
      if (!both_given("flow.probe", at, "a place has an x and a y") || at[0] == 2) continue;
      number_[k] = static_cast<int>(flow_.probes.size());
      flow_.probes.push_back({deck_.real("flow.probe", 1, k), deck_.real("flow.probe", 2, k)});
    }
  }
  void differences() {
    for (const Subscript at : deck_.given_elements("flow.difference")) {
      const int k = at[1];
      if (!both_given("flow.difference", at, "a difference is one of two probes")) continue;
      if (!deck_.given("flow.probe", 1, deck_.integer("flow.difference", at[0], k)))
        refuse("flow.difference", at, fmt::format("there is no probe {}", deck_.integer("flow.difference", at[0], k)),
               "the numbers are those of probe(1:2,k)");
      if (at[0] == 2) flow_.differences.push_back({probe(1, k), probe(2, k)});
    }
  }
  void tracers() {
    const bool counted[] = {deck_.given("flow.tracers", 1), deck_.given("flow.tracers", 2)};
    const auto box = deck_.given_elements("flow.tracer_box");
    if (!counted[0] && !counted[1]) {
      if (!box.empty())
        refuse("flow.tracer_box", box[0], "there are no tracers in this box", "tracers=20,10 places some");
      return;
    }
    if (!counted[0] || !counted[1])
      return refuse("flow.tracers", {counted[0] ? 1 : 2, 1}, "tracers has one of its two numbers", "along x, along y");
    const Box<2> extent = extent_of_mesh();
    TracerGrid& tracers = flow_.tracers;
    tracers = {.count = {deck_.integer("flow.tracers", 1), deck_.integer("flow.tracers", 2)}, .box = extent};
    if (box.empty()) return;
    if (box.size() < 4)
      return refuse("flow.tracer_box", box[0], fmt::format("tracer_box has {} of its four numbers", box.size()),
                    "xleft, xright, ybot, ytop");
    const auto number = [&](int k) { return deck_.real("flow.tracer_box", k); };
    tracers.box = {{number(1), number(3)}, {number(2), number(4)}};
    check_box(extent);
  }

 private:
  void refuse(AnyVariable name, Subscript at, const std::string& message, const std::string& hint) {
    diagnostics_.add(deck_.remark(Severity::error, name, at, message, hint));
  }
  /// Returns whether both elements of a column are given, and reports the lack of one at the other.
  bool both_given(AnyVariable name, Subscript at, const char* hint) {
    const int other = 3 - at[0];
    if (deck_.given(name, other, at[1])) return true;
    refuse(name, at, fmt::format("{}({},{}) is not given", name, other, at[1]), hint);
    return false;
  }
  int probe(int i, int k) const {
    const auto found = number_.find(deck_.integer("flow.difference", i, k));
    return found == number_.end() ? 0 : found->second;
  }
  /// xleft, xright, ybot, ytop.
  Box<2> extent_of_mesh() const {
    const std::vector<double>& x = flow_.mesh.x;
    Box<2> extent{{x[0], x[1]}, {x[0], x[1]}};
    for (std::size_t n = 0; n < x.size(); n += 2) extent.add(Vec<2>{x[n], x[n + 1]});
    return extent;
  }
  void check_box(const Box<2>& extent) {
    const auto& [low, high] = flow_.tracers.box;
    if (!(low[0] < high[0]) || !(low[1] < high[1]))
      return refuse("flow.tracer_box", {low[0] < high[0] ? 4 : 2, 1}, "the box of tracers is empty",
                    "xleft, xright, ybot, ytop, the lower first");
    const double slack = 1e-9 * std::max(extent.high[0] - extent.low[0], extent.high[1] - extent.low[1]);
    const std::array<double, 4> beyond{extent.low[0] - low[0], high[0] - extent.high[0], extent.low[1] - low[1],
                                       high[1] - extent.high[1]};
    for (std::size_t k = 0; k < 4; ++k) {
      if (beyond[k] <= slack) continue;
      return refuse("flow.tracer_box", {static_cast<int>(k) + 1, 1},
                    fmt::format("the box of tracers goes beyond the fluid by {:.6g}", beyond[k]),
                    fmt::format("the fluid lies between x = {:.6g} and {:.6g}, y = {:.6g} and {:.6g}", extent.low[0],
                                extent.high[0], extent.low[1], extent.high[1]));
    }
  }

  const Deck& deck_;
  Flow& flow_;
  Diagnostics& diagnostics_;
  std::map<int, int> number_;  // of the deck's probes among the flow's
};

}  // namespace

void add_probes(const Deck& deck, Flow& flow, Diagnostics& diagnostics) {
  ProbeReader reader(deck, flow, diagnostics);
  reader.probes();
  reader.differences();
  reader.tracers();
}

}  // namespace tether
