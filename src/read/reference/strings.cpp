// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/bars.hpp"
#include "read/reference/reference.hpp"

namespace tether {
namespace {

/// Part of a spacing by which points may stand off their places on a straight line: a printed file has six decimals.
constexpr double straightness = 0.01;
/// Part by which what is called equal may differ.
constexpr double alike = 1e-3;

/// The scene's one string, and what the solutions ask of it.
class TrackedString {
 public:
  explicit TrackedString(const Scene& scene)
      : scene_(scene),
        P_(scene.points),
        body_(count_bodies<Membrane>(scene) == 1 ? find_body<Membrane>(scene) : nullptr) {
    if (!body_) return;
    first_ = body_->first, last_ = body_->first + body_->count - 1;
    end_ = held_end(scene, *body_);
  }

  /// Returns whether the point tracked last is the last of the string: the mass.
  bool is_tracked() const { return body_ && !scene_.tracked.empty() && scene_.tracked.back() == last_; }
  bool is_at_rest() const { return begins_at_rest(scene_, *body_); }
  bool slides() const { return end_->slides; }
  double x() const { return P_.x[last_]; }
  double y() const { return P_.y[last_]; }
  double held_x() const { return end_->x; }
  double held_y() const { return end_->y; }
  double mass() const { return P_.mass[last_]; }
  double length() const { return std::hypot(x() - end_->x, y() - end_->y); }

  /// Says what the scene lacks of what all the solutions need.
  std::string lacks() const {
    if (scene_.geometry != Geometry::plane) return "a plane scene, not one about an axis";
    if (body_->count < 2 || body_->closed || !is_straight())
      return "a string whose points stand evenly on a straight line";
    if (!is_uniform()) return "points of one volume and mass, but for the string's last one, the mass";
    if (!end_) {
      return "a string that is held: its first point pinned, or in the row of cells beside a wall that holds it, "
             "straight on";
    }
    const double gap = std::hypot(P_.x[first_] - end_->x, P_.y[first_] - end_->y);
    if (gap > (1 + straightness) * spacing()) {
      return "points up to what holds the string: its first one is more than a spacing from the wall, and nothing is "
             "in "
             "between";
    }
    return "";
  }
  bool hangs() const { return std::abs(x() - end_->x) < alike * length() && end_->y > y(); }

  double smallest_strain() const { return extreme_strain(std::less<>()); }
  double largest_strain() const { return extreme_strain(std::greater<>()); }
  /// E A / L of the string from where it is held.
  double stiffness() const {
    const std::size_t inner = body_->count > 2 ? first_ + 1 : first_;
    return law().E * P_.volume[inner] / spacing() / length();
  }
  double slack() const {
    double sum = 0;
    for (std::size_t p = first_; p <= last_; ++p) sum += spacing() * std::max(0.0, -strain(p));
    return sum;
  }
  const Membrane& law() const { return std::get<Membrane>(body_->material); }

  /// Returns whether a place is inside the grid and out of reach of walls that hold what goes across or along them: the
  /// cells beside such a wall are stuck to it.
  bool is_free(double x, double y) const {
    const BackgroundGrid& g = scene_.grid;
    const bool material_points = scene_.path() == Path::mpm;
    const auto room = [&](Wall wall, double cell) { return material_points && wall != Wall::open ? cell : 0; };
    return x >= g.x0 + room(scene_.walls.left, g.dx) && x <= g.x1 - room(scene_.walls.right, g.dx) &&
           y >= g.y0 + room(scene_.walls.bottom, g.dy);
  }
  /// Returns whether a string that hangs is free to: no wall at its sides holds it along itself.
  bool is_free_to_hang(double lowest) const {
    const BackgroundGrid& g = scene_.grid;
    const bool held = scene_.path() == Path::mpm && ((scene_.walls.left == Wall::fixed && x() - g.x0 < g.dx) ||
                                                     (scene_.walls.right == Wall::fixed && g.x1 - x() < g.dx));
    const bool bottom = scene_.path() == Path::mpm && scene_.walls.bottom != Wall::open;
    return !held && lowest >= g.y0 + (bottom ? g.dy : 0);
  }

 private:
  double spacing() const {
    return std::hypot(P_.x[last_] - P_.x[first_], P_.y[last_] - P_.y[first_]) / static_cast<double>(body_->count - 1);
  }
  double strain(std::size_t p) const { return (P_.sxx[p] + P_.syy[p]) / law().E; }
  template <class Compare>
  double extreme_strain(Compare compare) const {
    double extreme = strain(first_);
    for (std::size_t p = first_; p <= last_; ++p) {
      if (compare(strain(p), extreme)) extreme = strain(p);
    }
    return extreme;
  }
  bool is_straight() const {
    for (std::size_t p = first_; p <= last_; ++p) {
      const double part = static_cast<double>(p - first_) / static_cast<double>(body_->count - 1);
      const double x = P_.x[first_] + part * (P_.x[last_] - P_.x[first_]);
      const double y = P_.y[first_] + part * (P_.y[last_] - P_.y[first_]);
      if (std::hypot(P_.x[p] - x, P_.y[p] - y) > straightness * spacing()) return false;
    }
    return true;
  }
  /// The ends of a curve may stand for half a piece.
  bool is_uniform() const {
    const std::size_t inner = first_ + 1;
    for (std::size_t p = inner; p < last_; ++p) {
      if (std::abs(P_.volume[p] - P_.volume[inner]) > alike * P_.volume[inner]) return false;
      if (std::abs(P_.mass[p] - P_.mass[inner]) > alike * P_.mass[inner]) return false;
    }
    return body_->count == 2 || P_.mass[first_] <= (1 + alike) * P_.mass[inner];
  }

  const Scene& scene_;
  const PointSet& P_;
  const Body* body_;
  std::size_t first_ = 0, last_ = 0;
  std::optional<HeldEnd> end_;
};

std::string lacks_of_a_string_alone(const Scene& scene, const TrackedString& string) {
  if (!string.is_tracked() || !string.is_at_rest() || !(scene.gravity < 0)) {
    return "a string from a particle file that begins at rest, its last point tracked, and gravc < 0";
  }
  if (scene.bodies.size() > 1) return "a string alone: no other body";
  return string.lacks();
}

constexpr const char* downwards = "a string that hangs straight down from where it is held";
constexpr const char* room =
    "room: the grid down to the lowest place, without walls that hold the string at its sides or the mass below";

}  // namespace

std::string lacks_for_spring(const Scene& scene) {
  const TrackedString string(scene);
  const std::string lacking = lacks_of_a_string_alone(scene, string);
  if (!lacking.empty()) return lacking;
  if (!string.hangs()) return downwards;
  if (string.smallest_strain() != 0 || string.largest_strain() != 0) return "a spring without stress at the start";
  const double drop = 2 * string.mass() * -scene.gravity / string.stiffness();
  return string.is_free_to_hang(string.y() - drop) ? "" : room;
}

std::string lacks_for_string(const Scene& scene) {
  const TrackedString string(scene);
  const std::string lacking = lacks_of_a_string_alone(scene, string);
  if (!lacking.empty()) return lacking;
  if (!string.hangs()) return downwards;
  if (string.largest_strain() > 0) return "a string without tension at the start";
  if (!string.law().wrinkle) return "a string that carries no compression (wrinkle=.true.)";
  const double hang = string.mass() * -scene.gravity / string.stiffness(), slack = string.slack();
  const double drop = slack + hang + std::sqrt(hang * hang + 2 * slack * hang);
  return string.is_free_to_hang(string.y() - drop) ? "" : room;
}

std::string lacks_for_pendulum(const Scene& scene) {
  const TrackedString string(scene);
  const std::string lacking = lacks_of_a_string_alone(scene, string);
  if (!lacking.empty()) return lacking;
  if (string.slides()) return "a string whose end is fixed: here it slides along its wall";
  if (!(string.y() < string.held_y())) return "a string at less than 90 degrees from the vertical, which stays taut";
  if (string.smallest_strain() < 0) return "a string without slack at the start";
  const double other_side = 2 * string.held_x() - string.x(), lowest = string.held_y() - string.length();
  const bool free = string.is_free(string.x(), lowest) && string.is_free(other_side, lowest);
  return free ? "" : "room: the whole swing inside the grid, a cell away from walls that are not open";
}

std::string lacks_for_piston(const Scene& scene) {
  const TrackedString spring(scene);
  if (!spring.is_tracked() || count_bodies<LinearFluid>(scene) != 1) {
    return "a linear fluid, a spring from a particle file, its last point tracked";
  }
  if (scene.bodies.size() > 2) return "a linear fluid and a spring alone: no other body";
  const std::string lacking = spring.lacks();
  if (!lacking.empty()) return lacking;
  if (!spring.hangs()) return downwards;
  if (scene.gravity != 0) return "gravc = 0";
  if (spring.law().wrinkle) return "a spring that carries compression (wrinkle=.false.)";
  const Body& fluid = *find_body<LinearFluid>(scene);
  const auto begin = scene.points.y.begin() + static_cast<std::ptrdiff_t>(fluid.first);
  const auto [low, high] = std::minmax_element(begin, begin + static_cast<std::ptrdiff_t>(fluid.count));
  if (*low == *high) return "a column of fluid of more than one row of points";
  if (scene.walls.bottom == Wall::open || *low - scene.grid.y0 > scene.grid.dy) {
    return "a column of fluid that stands on a bottom wall that holds it";
  }
  if (!begins_at_rest(scene, fluid)) return "a fluid at rest at the start";
  const double gap = spring.y() - *high;
  return gap > 0 && gap < 1.5 * scene.grid.dy ? "" : "a piston, the spring's last point, on top of the fluid";
}

}  // namespace tether
