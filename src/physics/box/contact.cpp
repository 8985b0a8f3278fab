// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/numbers.hpp"

namespace tether::coupled {
namespace {

constexpr double rounding = 1e-9;  // of a cell
constexpr int chances = 3;         // of block pivoting

/// The unit vector along x, or against it; zero of none.
Vec<3> towards(const Vec<3>& x, double sign) {
  const double size = sign * std::sqrt(dot(x, x));
  return size == 0 ? Vec<3>{} : Vec<3>{x[0] / size, x[1] / size, x[2] / size};
}

}  // namespace

Contact::Contact(const Coupled& scene, const SolidSurface& surface)
    : scene_(scene), dim_(at(scene.grid.dim)), nodes_(surface.sides) {
  std::sort(nodes_.begin(), nodes_.end());
  nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
}

void Contact::begin(std::span<const double> q, std::span<const double> u, double h, std::vector<Touch>& touches) {
  h_ = h;
  fewest_ = std::numeric_limits<std::size_t>::max(), chances_ = chances;
  meetings_.clear();
  const double size = *std::max_element(scene_.grid.d.begin(), scene_.grid.d.begin() + scene_.grid.dim);
  for (const int node : nodes_) {
    if (!scene_.contact) break;
    const Vec<3> x = place_of(q, node, scene_.grid.dim), v = place_of(u, node, scene_.grid.dim);
    const double reach = size + 2 * h * std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    meet_walls(at(node), x, reach);
    for (const Box<3>& box : scene_.obstacles) meet_obstacle(box, at(node), x, reach);
  }
  std::vector<Touch> kept(touches.size(), Touch::away);
  for (Meeting& meeting : meetings_) {
    meeting.before = place_of(u, static_cast<int>(meeting.node), scene_.grid.dim);
    Touch& touch = kept[unknown(meeting)];
    if (touch != Touch::away || meeting.gap > rounding * size) continue;
    const Touch before = touches[unknown(meeting)];
    if (before != Touch::rebounds) touch = before == Touch::grips ? Touch::sticks : before;
    meeting.touching = touch != Touch::away;
  }
  touches = std::move(kept);
}

void Contact::meet_walls(std::size_t node, const Vec<3>& x, double reach) {
  for (int side = 0; side < 2 * scene_.grid.dim; ++side) {
    if (!is_wall(scene_.sides[at(side)])) continue;
    const int axis = axis_of_side(side);
    const double up = is_low_side(side) ? 1 : -1;
    const double place = is_low_side(side) ? scene_.grid.low[at(axis)] : scene_.grid.high(axis);
    const double gap = up * (x[at(axis)] - place);
    if (gap < reach) meetings_.push_back({node, at(axis), up, place, gap, x});
  }
}

/// At the face of the box that the node is least far beyond, or farthest before, of those that are a wall there.
void Contact::meet_obstacle(const Box<3>& box, std::size_t node, const Vec<3>& x, double reach) {
  Meeting nearest;
  nearest.gap = -INFINITY;
  for (std::size_t axis = 0; axis < dim_; ++axis) {
    for (const double up : {1.0, -1.0}) {
      const double place = up > 0 ? box.high[axis] : box.low[axis], gap = up * (x[axis] - place);
      if (gap > nearest.gap && !is_covered(box, axis, up, x)) nearest = {node, axis, up, place, gap, x, &box};
    }
  }
  if (nearest.box != nullptr && nearest.gap < reach) meetings_.push_back(nearest);
}

/// Returns whether a face of the box has another obstacle before it, where a node at x is nearest: obstacles side by
/// side, or one in another, are one.
bool Contact::is_covered(const Box<3>& box, std::size_t axis, double up, const Vec<3>& x) const {
  Vec<3> before = x;
  for (std::size_t i = 0; i < dim_; ++i) before[i] = std::clamp(x[i], box.low[i], box.high[i]);
  before[axis] = (up > 0 ? box.high[axis] : box.low[axis]) + up * rounding * scene_.grid.d[axis];
  return std::any_of(scene_.obstacles.begin(), scene_.obstacles.end(), [&](const Box<3>& other) {
    bool holds = &other != &box;
    for (std::size_t i = 0; i < dim_; ++i) holds = holds && before[i] >= other.low[i] && before[i] <= other.high[i];
    return holds;
  });
}

void Contact::hold(std::span<const Touch> touches, std::span<std::uint8_t> held, std::span<double> u1) const {
  for (const Meeting& meeting : meetings_) {
    if (!meeting.touching) continue;
    const Touch touch = touches[unknown(meeting)];
    for (std::size_t i = 0; (touch == Touch::sticks || touch == Touch::grips) && i < dim_; ++i)
      held[meeting.node * dim_ + i] = 1, u1[meeting.node * dim_ + i] = touch == Touch::grips ? -meeting.before[i] : 0;
    held[unknown(meeting)] = 1, u1[unknown(meeting)] = touch == Touch::rebounds ? rebound(meeting) : 0;
  }
}

std::vector<double> Contact::lifts(std::span<const Touch> touches, std::size_t unknowns) const {
  std::vector<double> lifts(unknowns, 0.0);
  for (const Meeting& meeting : meetings_) {
    if (!meeting.touching || touches[unknown(meeting)] == Touch::rebounds) continue;
    lifts[unknown(meeting)] = lift(meeting);
  }
  return lifts;
}

/// Down, too: a node that is halted before it reaches the wall would else stay above it.
double Contact::lift(const Meeting& meeting) const {
  return -meeting.side * meeting.gap - 0.5 * h_ * meeting.before[meeting.axis];
}

void Contact::add_friction(std::span<double> forces) const {
  for (const Meeting& meeting : meetings_) {
    for (std::size_t i = 0; i < dim_; ++i) forces[meeting.node * dim_ + i] += meeting.friction * meeting.along[i];
  }
}

bool Contact::changed(std::span<const double> u1, std::span<const double> reactions, std::span<const double> inertia,
                      std::vector<Touch>& touches) {
  constexpr double same = 1e-4;  // of the largest friction
  bool changed = false;
  double largest = 0, farthest = 0;
  std::vector<std::pair<Meeting*, Touch>> wrong;  // of those that can but rebound
  for (Meeting& meeting : meetings_) {
    Touch& touch = touches[unknown(meeting)];
    if (touch != Touch::away && !meeting.touching) continue;  // another wall across the same axis has it
    const double before = meeting.friction;
    const bool rebounds = meeting.released;
    const Touch then = next(meeting, touch, u1, reactions, inertia);
    changed = changed || then != touch;
    if (rebounds && then != touch) wrong.emplace_back(&meeting, then);
    if (!rebounds && meeting.released) fewest_ = std::numeric_limits<std::size_t>::max(), chances_ = chances;
    if (!rebounds) touch = then, meeting.touching = then != Touch::away;
    largest = std::max(largest, meeting.friction);
    farthest = std::max(farthest, std::abs(meeting.friction - before));
  }
  if (!wrong.empty() && !all_at_once(wrong.size())) wrong.erase(wrong.begin(), wrong.end() - 1);
  for (const auto& [meeting, then] : wrong) {
    if (then != Touch::away && touches[unknown(*meeting)] != Touch::away) continue;
    touches[unknown(*meeting)] = then, meeting->touching = then != Touch::away;
  }
  return changed || farthest > same * largest;
}

/// Block pivoting: all nodes that are wrong change as long as they become fewer; for a while they may not, and then one
/// at a time changes, the last in a fixed order, which ends with the solution (Murty).
bool Contact::all_at_once(std::size_t wrong) {
  if (wrong < fewest_) {
    fewest_ = wrong, chances_ = chances;
    return true;
  }
  return chances_-- > 0;
}

/// Returns whether the place is beyond the wall and, where the wall is an obstacle's, in the obstacle: the plane of its
/// face is no wall farther out.
bool Contact::is_behind(const Meeting& meeting, const Vec<3>& x) const {
  const std::size_t axis = meeting.axis;
  if (meeting.side * (x[axis] - meeting.place) >= -rounding * scene_.grid.d[axis]) return false;
  for (std::size_t i = 0; meeting.box != nullptr && i < dim_; ++i) {
    const double edge = rounding * scene_.grid.d[i];
    if (i != axis && (x[i] <= meeting.box->low[i] + edge || x[i] >= meeting.box->high[i] - edge)) return false;
  }
  return true;
}

/// A node whose way (5) leads through the wall touches it; one that the wall would have to pull leaves it, and rebounds
/// where that leads through the wall. Multiplied by the step's way d, the equations (4) say that contact gives the
/// solids the energy R.d - M (u1 - u0)/h . (lift), and a node whose part of that is above zero is not halted either.
/// (M (u1 - u0) can be against the node's own change, by its neighbours'.)
Touch Contact::next(Meeting& meeting, Touch now, std::span<const double> u1, std::span<const double> reactions,
                    std::span<const double> inertia) const {
  if (now == Touch::away) {
    Vec<3> x = meeting.from;
    for (std::size_t i = 0; i < dim_; ++i) x[i] += 0.5 * h_ * (meeting.before[i] + u1[meeting.node * dim_ + i]);
    if (!is_behind(meeting, x)) return Touch::away;
    if (meeting.released) return Touch::rebounds;
    return scene_.friction > 0 ? Touch::sticks : Touch::slides;
  }
  const double pressed = meeting.side * reactions[unknown(meeting)];
  const double given = -pressed * meeting.gap - lift(meeting) * inertia[unknown(meeting)] / h_;
  if (pressed < 0 || (now != Touch::rebounds && given > 0)) {
    meeting.released = true, meeting.friction = 0;
    return Touch::away;
  }
  return scene_.friction > 0 ? rubbed(meeting, now, pressed, u1, reactions) : now;
}

/// A node's values along the wall.
Vec<3> Contact::along_wall(const Meeting& meeting, std::span<const double> values) const {
  Vec<3> along{};
  for (std::size_t i = 0; i < dim_; ++i) along[i] = i == meeting.axis ? 0 : values[meeting.node * dim_ + i];
  return along;
}

/// Coulomb: a node that sticks begins to slide where that takes more than mu times the pressing force. One that slides
/// is rubbed by that much; where that would drive it back, it sticks for the rest of the step. A node that comes sticks
/// first: an impact is not rubbed by more than stops it. But by (5) the step's way is h (u0 + u1)/2, along which
/// friction must not drive a node either. One that is halted goes h u0/2, and where a force along that way is what
/// halts it, it is rubbed against u0 instead; where that turns its way, it does not move at all.
Touch Contact::rubbed(Meeting& meeting, Touch now, double pressed, std::span<const double> u1,
                      std::span<const double> reactions) const {
  if (now == Touch::grips) return now;
  const double most = scene_.friction * pressed;
  Vec<3> first = meeting.before;
  first[meeting.axis] = 0;
  const Vec<3> last = along_wall(meeting, u1), way{first[0] + last[0], first[1] + last[1], first[2] + last[2]};
  if (now == Touch::sticks) {
    const Vec<3> held = along_wall(meeting, reactions);
    const bool driven = dot(held, first) > 0;
    if (!driven && (meeting.turned || std::sqrt(dot(held, held)) <= most)) return now;
    meeting.driven = driven;
    meeting.along = driven ? towards(first, -1) : towards(held, 1), meeting.friction = most;
    return Touch::slides;
  }
  if (dot(meeting.along, meeting.along) == 0) meeting.along = towards(way, -1);
  const bool halts = now == Touch::slides && !meeting.driven;
  const bool turns =
      dot(meeting.along, meeting.along) == 0 || dot(meeting.along, way) > 0 || (halts && dot(meeting.along, last) > 0);
  meeting.turned = meeting.turned || turns;
  meeting.friction = turns || (now == Touch::rebounds && meeting.turned) ? 0 : most;
  if (now == Touch::rebounds || !turns) return now;
  return meeting.driven ? Touch::grips : Touch::sticks;
}

void Contact::place(std::span<double> q) const {
  for (const Meeting& meeting : meetings_) {
    double& x = q[unknown(meeting)];
    const bool stays =
        meeting.side * (x - meeting.place) >= 0 ||
        (meeting.box != nullptr && !is_behind(meeting, place_of(q, static_cast<int>(meeting.node), scene_.grid.dim)));
    if (meeting.touching || !stays) x = meeting.place;
  }
}

}  // namespace tether::coupled
