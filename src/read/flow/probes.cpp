// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "read/flow/flow_of_deck.hpp"

namespace tether {
namespace {

/// Reads what of a flow is recorded inside of it.
class ProbeReader {
 public:
  ProbeReader(const Deck& deck, Flow& flow, Diagnostics& diagnostics)
      : deck_(deck), flow_(flow), diagnostics_(diagnostics) {}

  void probes() {
    for (const Subscript at : deck_.given_elements("flow", "probe")) {
      const int k = at[1];
      if (!both_given("probe", at, "a place has an x and a y") || at[0] == 2) continue;
      number_[k] = static_cast<int>(flow_.probes.size());
      flow_.probes.push_back({deck_.real("flow", "probe", 1, k), deck_.real("flow", "probe", 2, k)});
    }
  }
  void differences() {
    for (const Subscript at : deck_.given_elements("flow", "difference")) {
      const int k = at[1];
      if (!both_given("difference", at, "a difference is one of two probes")) continue;
      if (!deck_.given("flow", "probe", 1, deck_.integer("flow", "difference", at[0], k)))
        refuse("difference", at, fmt::format("there is no probe {}", deck_.integer("flow", "difference", at[0], k)),
               "the numbers are those of probe(1:2,k)");
      if (at[0] == 2) flow_.differences.push_back({probe(1, k), probe(2, k)});
    }
  }
  void tracers() {
    const bool counted[] = {deck_.given("flow", "tracers", 1), deck_.given("flow", "tracers", 2)};
    const auto box = deck_.given_elements("flow", "tracer_box");
    if (!counted[0] && !counted[1]) {
      if (!box.empty()) refuse("tracer_box", box[0], "there are no tracers in this box", "tracers=20,10 places some");
      return;
    }
    if (!counted[0] || !counted[1])
      return refuse("tracers", {counted[0] ? 1 : 2, 1}, "tracers has one of its two numbers", "along x, along y");
    const auto extent = extent_of_mesh();
    TracerBox& tracers = flow_.tracers;
    tracers = {{deck_.integer("flow", "tracers", 1), deck_.integer("flow", "tracers", 2)},
               extent[0],
               extent[1],
               extent[2],
               extent[3]};
    if (box.empty()) return;
    if (box.size() < 4)
      return refuse("tracer_box", box[0], fmt::format("tracer_box has {} of its four numbers", box.size()),
                    "xleft, xright, ybot, ytop");
    const auto number = [&](int k) { return deck_.real("flow", "tracer_box", k); };
    tracers.x0 = number(1), tracers.x1 = number(2), tracers.y0 = number(3), tracers.y1 = number(4);
    check_box(extent);
  }

 private:
  void refuse(const char* name, Subscript at, const std::string& message, const std::string& hint) {
    diagnostics_.add(deck_.remark(Severity::error, "flow", name, at, message, hint));
  }
  /// Whether both elements of a column are given, which is told at the one that is.
  bool both_given(const char* name, Subscript at, const char* hint) {
    const int other = 3 - at[0];
    if (deck_.given("flow", name, other, at[1])) return true;
    refuse(name, at, fmt::format("{}({},{}) is not given", name, other, at[1]), hint);
    return false;
  }
  int probe(int i, int k) const {
    const auto found = number_.find(deck_.integer("flow", "difference", i, k));
    return found == number_.end() ? 0 : found->second;
  }
  /// xleft, xright, ybot, ytop.
  std::array<double, 4> extent_of_mesh() const {
    const std::vector<double>& x = flow_.mesh.x;
    std::array extent{x[0], x[0], x[1], x[1]};
    for (std::size_t n = 0; n < x.size(); ++n) {
      const std::size_t i = n % 2 * 2;
      extent[i] = std::min(extent[i], x[n]), extent[i + 1] = std::max(extent[i + 1], x[n]);
    }
    return extent;
  }
  void check_box(const std::array<double, 4>& extent) {
    const TracerBox& box = flow_.tracers;
    if (!(box.x0 < box.x1) || !(box.y0 < box.y1))
      return refuse("tracer_box", {box.x0 < box.x1 ? 4 : 2, 1}, "the box of tracers is empty",
                    "xleft, xright, ybot, ytop, the lower first");
    const double slack = 1e-9 * std::max(extent[1] - extent[0], extent[3] - extent[2]);
    const std::array<double, 4> beyond{extent[0] - box.x0, box.x1 - extent[1], extent[2] - box.y0, box.y1 - extent[3]};
    for (std::size_t k = 0; k < 4; ++k) {
      if (beyond[k] <= slack) continue;
      return refuse("tracer_box", {static_cast<int>(k) + 1, 1},
                    fmt::format("the box of tracers goes beyond the fluid by {:.6g}", beyond[k]),
                    fmt::format("the fluid lies between x = {:.6g} and {:.6g}, y = {:.6g} and {:.6g}", extent[0],
                                extent[1], extent[2], extent[3]));
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
