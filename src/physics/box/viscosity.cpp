// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/viscosity.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/numbers.hpp"

namespace tether::coupled {
namespace {

constexpr double least_part = 0.25;    // of a face's box, as explicit steps bear
constexpr double largest_share = 0.8;  // of a face's velocity that a step may give away; at 1 ripples would not decay

// The Laplacian at the open faces across an axis: for each, weights of the faces before and after it on each axis; and
// what bodies beside them do.
template <std::size_t dim>
class Laplacian {
 public:
  Laplacian(const FlowDomain& domain, int axis, bool walls_no_slip, StickingBodies* bodies)
      : domain_(domain),
        grid_(domain.grid),
        axis_(axis),
        no_slip_(walls_no_slip),
        bodies_(bodies),
        drag_(domain.grid, axis) {
    if (bodies != nullptr) near_.emplace(grid_, axis, bodies->beside[static_cast<std::size_t>(axis)]);
    const auto m = grid_.faces(axis);
    stride_ = {1, m[0], m[0] * m[1]};
    const auto& kind = domain.face[static_cast<std::size_t>(axis)];
    std::size_t f = 0;
    for (int k = 0; k < m[2]; ++k) {
      for (int j = 0; j < m[1]; ++j) {
        for (int i = 0; i < m[0]; ++i, ++f) {
          if (kind[f] == FaceKind::open) add_row(f, {i, j, k});
        }
      }
    }
    change_.resize(row_.size());
  }

  double largest() const { return largest_; }

  /// A step of a time h: nu times the Laplacian, what drives faces and bodies meanwhile [acceleration], and the drag.
  void step(std::vector<double>& v, double nu, double h, const std::vector<double>* driven) {
    diffuse(v, h * nu);
    if (driven != nullptr) {
      for (const Row& row : row_) v[row.face] += h * (*driven)[row.face];
    }
    if (bodies_ == nullptr) return;
    for (std::size_t k = static_cast<std::size_t>(axis_); k < bodies_->u.size(); k += dim)
      bodies_->u[k] += h * bodies_->driven[k];
    drag_.act(nu, h, *bodies_, v);
  }

  void take_back(std::vector<double>& v, double h, const std::vector<double>& driven) const {
    for (const Row& row : row_) v[row.face] -= h * driven[row.face];
  }

 private:
  struct Row {
    std::size_t face;
    double own = 0;
    std::array<double, dim> lower{}, upper{};
  };

  void diffuse(std::vector<double>& v, double by) {
    for (std::size_t r = 0; r < row_.size(); ++r) {
      const Row& row = row_[r];
      const double* u = v.data() + row.face;
      double sum = -row.own * u[0];
      for (std::size_t b = 0; b < dim; ++b) {
        if (row.lower[b] != 0) sum += row.lower[b] * u[-stride_[b]];
        if (row.upper[b] != 0) sum += row.upper[b] * u[stride_[b]];
      }
      change_[r] = by * sum;
    }
    for (std::size_t r = 0; r < row_.size(); ++r) v[row_[r].face] += change_[r];
  }

  void add_row(std::size_t f, const std::array<int, 3>& place) {
    Row row{f};
    for (std::size_t b = 0; b < dim; ++b) {
      for (const bool up : {false, true}) {
        double& weight = up ? row.upper[b] : row.lower[b];
        double held = 0;
        if (!sticks(place, f, b, up) && !is_within(f))
          static_cast<int>(b) == axis_ ? ahead(place, f, up, weight) : beside(place, f, b, up, weight, held);
        const double scale = 1 / (grid_.d[b] * grid_.d[b] * part(f));
        if (weight != 0) weight *= scale * std::max(part(f), part(next(f, b, up)));
        row.own += weight + held * scale;
      }
    }
    largest_ = std::max(largest_, row.own);
    row_.push_back(row);
  }

  FaceKind kind(std::size_t axis, std::size_t face) const { return domain_.face[axis][face]; }

  std::size_t next(std::size_t f, std::size_t b, bool up) const {
    return f + static_cast<std::size_t>(up ? stride_[b] : -stride_[b]);
  }

  // Whether the middle of a face lies in a body, which then carries along what little fluid the face has.
  bool is_within(std::size_t f) const {
    return bodies_ != nullptr && bodies_->beside[static_cast<std::size_t>(axis_)].inside[f] != 0;
  }

  // How much of a face's box is fluid, where bodies cut it: what two faces exchange is by the larger part of both, as
  // along a body they have the same, and towards it the farther one is whole. So momentum that one loses the other has.
  double part(std::size_t f) const {
    if (bodies_ == nullptr) return 1;
    const auto a = static_cast<std::size_t>(axis_);
    return std::max(domain_.volume[a][f] / whole_box(grid_, axis_, f), least_part);
  }

  // Whether a body is next on this side, which then drags the face along. A wall may be nearer.
  bool sticks(const std::array<int, 3>& place, std::size_t f, std::size_t b, bool up) {
    if (bodies_ == nullptr) return false;
    const auto a = static_cast<std::size_t>(axis_);
    const bool last = place[b] == (up ? grid_.faces(axis_)[b] - 1 : 0);
    auto near = near_->between(place, b, up);
    if (near && near->cells > 0.5 && (last || wall_beside(place, b, up))) near.reset();
    if (!near && !last && kind(a, next(f, b, up)) == FaceKind::closed) near = near_->closing(place, b, up);
    if (!near) return false;
    drag_.join(f, domain_.volume[a][f], b, *near, is_within(f));
    return true;
  }

  // The faces across b of the cells on both sides of a face: where it leads on along b.
  template <class Function>
  void each_way(const std::array<int, 3>& place, std::size_t b, bool up, const Function& f) const {
    const auto a = static_cast<std::size_t>(axis_);
    for (const int back : {1, 0}) {
      auto between = place;
      between[a] -= back;
      if (between[a] < 0 || between[a] == grid_.n[a]) continue;
      between[b] += up;
      f(kind(b, grid_.face(static_cast<int>(b), between)), between[b] > 0 && between[b] < grid_.n[b]);
    }
  }

  // Obstacles hold the fluid, and so do the sides of the box along which it does not slip.
  bool holds(bool inside, std::size_t b, bool up) const { return no_slip_ && (inside || !domain_.slips[2 * b + up]); }

  bool wall_beside(const std::array<int, 3>& place, std::size_t b, bool up) const {
    bool wall = false;
    if (static_cast<int>(b) == axis_) return wall;
    each_way(place, b, up, [&](FaceKind way, bool) { wall = wall || way == FaceKind::prescribed; });
    return wall;
  }

  // The next face along the own axis counts unless a solid closes it, and with it the value.
  void ahead(const std::array<int, 3>& place, std::size_t f, bool up, double& weight) const {
    const auto a = static_cast<std::size_t>(axis_);
    if (place[a] == (up ? grid_.n[a] : 0)) return;
    if (kind(a, next(f, a, up)) != FaceKind::closed) weight = 1;
  }

  // The next face across: through each half of what lies between, which belongs to one of the two cells beside.
  void beside(const std::array<int, 3>& place, std::size_t f, std::size_t b, bool up, double& weight,
              double& held) const {
    const auto a = static_cast<std::size_t>(axis_);
    const double share = place[a] == 0 || place[a] == grid_.n[a] ? 1 : 0.5;
    each_way(place, b, up, [&](FaceKind way, bool inside) {
      if (way == FaceKind::prescribed && holds(inside, b, up)) held += 2 * share;  // half as far, at rest
      const bool leads_on = way == FaceKind::open || (way == FaceKind::closed && bodies_ != nullptr);
      if (leads_on && inside && kind(a, next(f, b, up)) != FaceKind::closed) weight += share;
    });
  }

  const FlowDomain& domain_;
  const StaggeredGrid& grid_;
  int axis_;
  bool no_slip_;
  StickingBodies* bodies_;
  Drag drag_;
  std::optional<NearSurface> near_;
  std::array<std::ptrdiff_t, 3> stride_{};
  std::vector<Row> row_;
  std::vector<double> change_;
  double largest_ = 0;
};

template <std::size_t dim>
int add_in(const FlowDomain& domain, FaceValues& v, double nu, double h, bool walls_no_slip, const FaceValues* driven,
           const std::function<bool()>& stop, StickingBodies* bodies) {
  if (bodies != nullptr) bodies->impulse.assign(bodies->u.size(), 0.0);
  std::vector<Laplacian<dim>> laplacian;
  double largest = 0;
  for (std::size_t a = 0; a < dim; ++a) {
    laplacian.emplace_back(domain, static_cast<int>(a), walls_no_slip, bodies);
    largest = std::max(largest, laplacian.back().largest());
  }
  const int steps = std::max(1, static_cast<int>(std::ceil(h * nu * largest / largest_share)));
  for (std::size_t a = 0; a < dim; ++a) {
    const std::vector<double>* along = driven == nullptr ? nullptr : &(*driven)[a];
    for (int i = 0; i < steps; ++i) {
      laplacian[a].step(v[a], nu, h / steps, along);
      if (stop && i % steps_between_questions == 0 && stop()) return -1;
    }
    if (along != nullptr) laplacian[a].take_back(v[a], h, *along);
  }
  return steps;
}

}  // namespace

int add_viscosity(const FlowDomain& domain, FaceValues& v, double nu, double h, bool walls_no_slip,
                  const FaceValues* driven, const std::function<bool()>& stop, StickingBodies* bodies) {
  if (h * nu == 0) return 0;
  return domain.grid.dim == 2 ? add_in<2>(domain, v, nu, h, walls_no_slip, driven, stop, bodies)
                              : add_in<3>(domain, v, nu, h, walls_no_slip, driven, stop, bodies);
}

double viscous_steps(const StaggeredGrid& grid, double nu, double h) {
  double around = 0;
  for (int axis = 0; axis < grid.dim; ++axis) around += 2 / (grid.d[at(axis)] * grid.d[at(axis)]);
  return h * nu * around / largest_share;
}

}  // namespace tether::coupled
