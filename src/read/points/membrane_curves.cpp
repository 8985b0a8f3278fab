// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/points/membrane_curves.hpp"
#include "base/vec.hpp"
#include "deck/words.hpp"
#include "read/values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>

namespace tether {
namespace {

/// Reads one curve's values and reports what is wrong with them at their places.
class CurveReader {
 public:
  CurveReader(const Deck& deck, int k, Diagnostics& diagnostics)
      : deck_(deck), k_(k), diagnostics_(diagnostics), kind_(word<CurveKind>(deck, "membrane.curve", k)) {}

  std::optional<Curve> read() const {
    const bool round = kind_ == CurveKind::arc || kind_ == CurveKind::ellipse;
    warn_of_idle_values(round);
    auto curve = round ? ellipse() : through_vertices();
    if (!curve || curve->length() > 0) return curve;
    error("membrane.curve", {k_, 1}, "it has no length", "its ends are at one place");
    return std::nullopt;
  }

 private:
  void tell(Severity severity, AnyVariable name, Subscript at, const std::string& message,
            const std::string& hint) const {
    diagnostics_.add(deck_.remark(severity, name, at, fmt::format("curve {}: {}", k_, message), hint));
  }
  void error(AnyVariable name, Subscript at, const std::string& message, const std::string& hint) const {
    tell(Severity::error, name, at, message, hint);
  }
  double real(RealVariable name) const { return deck_.real(name, k_); }

  bool needs(AnyVariable name, const char* hint) const {
    if (deck_.given(name, k_)) return true;
    error("membrane.curve", {k_, 1}, fmt::format("{}({}) is not given", name, k_), hint);
    return false;
  }

  /// Number of the last vertex that has an x or a y; 0 where there is none.
  int last_vertex() const {
    int last = 0;
    for (const AnyVariable name : Variables{"membrane.x", "membrane.y"}) {
      for (const Subscript at : deck_.given_elements(name)) {
        if (at[1] == k_) last = std::max(last, at[0]);
      }
    }
    return last;
  }

  void warn_of_idle_values(bool round) const {
    const auto warn = [&](AnyVariable name, Subscript at, const std::string& element) {
      tell(Severity::warning, name, at, fmt::format("{} has no effect on a curve '{}'", element, word_of(kind_)),
           round ? "it has a centre, half axes and two angles" : "it has vertices");
    };
    if (round && last_vertex() > 0) {
      const AnyVariable name = deck_.given("membrane.x", last_vertex(), k_) ? AnyVariable("membrane.x") : "membrane.y";
      warn(name, {last_vertex(), k_}, fmt::format("{}({},{})", name, last_vertex(), k_));
    }
    for (const AnyVariable name :
         Variables{"membrane.xc", "membrane.yc", "membrane.a", "membrane.b", "membrane.from", "membrane.to"}) {
      const bool used = round && !(kind_ == CurveKind::arc && name == "membrane.b");
      if (!used && deck_.given(name, k_)) warn(name, {k_, 1}, fmt::format("{}({})", name, k_));
    }
  }

  std::optional<Curve> ellipse() const {
    const bool arc = kind_ == CurveKind::arc;
    const char* hint = arc ? "an arc needs its radius a" : "an ellipse needs its half axes a and b";
    const bool has_a = needs("membrane.a", hint), has_b = arc || needs("membrane.b", hint);
    const double from = real("membrane.from"), to = real("membrane.to");
    const bool over = std::abs(to - from) > 360;
    if (over) {
      error("membrane.curve", {k_, 1}, fmt::format("from {:.6g} to {:.6g} degrees it covers itself", from, to),
            "a whole turn is 360 degrees");
    }
    if (!has_a || !has_b || over) return std::nullopt;
    return ellipse_arc({real("membrane.xc"), real("membrane.yc")}, real("membrane.a"),
                       real(arc ? RealVariable("membrane.a") : "membrane.b"), from, to);
  }

  std::optional<Curve> through_vertices() const {
    const bool line = kind_ == CurveKind::line;
    const int last = last_vertex();
    if (last < 2 || (line && last > 2)) {
      error("membrane.curve", {k_, 1},
            fmt::format("a {} has {} vertices, not {}", word_of(kind_), line ? "2" : "at least 2", last),
            line && last > 2 ? "a polyline takes more" : fmt::format("give x(1,{0}) and y(1,{0}) onward", k_));
      return std::nullopt;
    }
    std::vector<Vec<2>> vertices;
    for (int v = 1; v <= last; ++v) {
      if (!vertex_given(v)) return std::nullopt;
      vertices.push_back({deck_.real("membrane.x", v, k_), deck_.real("membrane.y", v, k_)});
    }
    if (!apart(vertices)) return std::nullopt;
    return kind_ == CurveKind::spline ? spline(vertices) : polyline(vertices);
  }

  bool vertex_given(int v) const {
    const bool x = deck_.given("membrane.x", v, k_), y = deck_.given("membrane.y", v, k_);
    if (x && y) return true;
    const AnyVariable there = x ? AnyVariable("membrane.x") : y ? AnyVariable("membrane.y") : "membrane.curve";
    error(there, x || y ? Subscript{v, k_} : Subscript{k_, 1},
          fmt::format("{}({},{}) is not given", x ? "y" : "x", v, k_), "each vertex needs an x and a y");
    return false;
  }

  /// Returns whether consecutive vertices are apart, and a spline that closes has three different ones.
  bool apart(const std::vector<Vec<2>>& vertices) const {
    for (std::size_t v = 1; v < vertices.size(); ++v) {
      if (distance(vertices[v - 1], vertices[v]) > 0) continue;
      const int number = static_cast<int>(v) + 1;
      error("membrane.x", {number, k_}, fmt::format("vertices {} and {} are at one place", number - 1, number),
            "leave one of them out");
      return false;
    }
    if (kind_ != CurveKind::spline || vertices.size() != 3 || distance(vertices.front(), vertices.back()) > 0)
      return true;
    error("membrane.curve", {k_, 1}, "a closed spline needs 3 vertices and the first once more, not 2",
          "two make no loop");
    return false;
  }

  const Deck& deck_;
  int k_;
  Diagnostics& diagnostics_;
  CurveKind kind_;
};

}  // namespace

bool gives_curves(const Deck& deck) { return !deck.given_elements("membrane.curve").empty(); }

std::vector<int> curve_numbers(const Deck& deck, int b) {
  std::vector<int> numbers;
  for (const Subscript at : deck.given_elements("membrane.curve")) {
    if (deck.integer("membrane.body", at[0]) == b) numbers.push_back(at[0]);
  }
  return numbers;
}

std::vector<NumberedCurve> curves_of(const Deck& deck, int b, Diagnostics& diagnostics) {
  std::vector<NumberedCurve> curves;
  for (const int k : curve_numbers(deck, b)) {
    if (auto curve = CurveReader(deck, k, diagnostics).read()) curves.push_back({k, std::move(*curve)});
  }
  return curves;
}

void check_joints(const Deck& deck, const std::vector<NumberedCurve>& curves, Diagnostics& diagnostics) {
  double length = 0;
  for (const auto& [k, curve] : curves) length += curve.length();
  for (std::size_t n = 1; n < curves.size(); ++n) {
    const auto& [k, curve] = curves[n];
    const Vec<2> end = curves[n - 1].curve.last(), begin = curve.first();
    const double gap = distance(end, begin);
    if (gap <= same_place * length) continue;
    const bool turned = distance(end, curve.last()) <= same_place * length;
    diagnostics.add(deck.remark(
        Severity::error, "membrane.curve", {k, 1},
        fmt::format("curve {} begins at ({:.6g}, {:.6g}), {:.3g} from ({:.6g}, {:.6g}), where curve {} ends", k,
                    begin[0], begin[1], gap, end[0], end[1], curves[n - 1].k),
        turned ? "its other end would meet: give it the other way round"
               : "curves of one membrane are joined in the order of their numbers"));
  }
}

void check_kinds(const Deck& deck, Diagnostics& diagnostics) {
  std::vector<int> told;
  for (const AnyVariable name : Variables{"membrane.body", "membrane.x", "membrane.y", "membrane.xc", "membrane.yc",
                                          "membrane.a", "membrane.b", "membrane.from", "membrane.to"}) {
    for (const Subscript at : deck.given_elements(name)) {
      const bool vertex = name == "membrane.x" || name == "membrane.y";
      const int k = vertex ? at[1] : at[0];
      if (deck.given("membrane.curve", k) || std::find(told.begin(), told.end(), k) != told.end()) continue;
      told.push_back(k);
      diagnostics.add(deck.remark(Severity::error, name, at, fmt::format("curve({}) is not given", k),
                                  "line, polyline, arc, ellipse or spline"));
    }
  }
}

}  // namespace tether
