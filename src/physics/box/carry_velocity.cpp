// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/carry_velocity.hpp"

#include <algorithm>

#include "base/blocks.hpp"
#include "physics/box/flow_paths.hpp"

namespace tether::coupled {
namespace {

template <int dim>
class Carrier {
 public:
  Carrier(Team& team, const FlowDomain& domain, const FaceValues& v, double h)
      : team_(team), domain_(domain), grid_(domain.grid), v_(v), h_(h), paths_(domain) {}

  void semi_lagrangian(const FaceValues& carried, FaceValues& out) const {
    for (int axis = 0; axis < dim; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      out[a] = carried[a];
      each_open_face(axis, [&](std::size_t f, const FlowPlace& middle) {
        out[a][f] = at_end_of_path(carried, axis, f, middle, -h_).value;
      });
    }
  }

  void maccormack(const FaceValues& carried, FaceValues& out) const {
    std::array<std::vector<FlowValue>, 3> once;
    for (int axis = 0; axis < dim; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      out[a] = carried[a];
      once[a].resize(out[a].size());
      each_open_face(axis, [&](std::size_t f, const FlowPlace& middle) {
        once[a][f] = at_end_of_path(carried, axis, f, middle, -h_);
        out[a][f] = once[a][f].value;
      });
    }
    for (int axis = 0; axis < dim; ++axis) correct(axis, carried, once[static_cast<std::size_t>(axis)], out);
  }

 private:
  void correct(int axis, const FaceValues& carried, const std::vector<FlowValue>& once, FaceValues& out) const {
    const auto a = static_cast<std::size_t>(axis);
    std::vector<double> corrected = out[a];  // its own neighbours must still be seen as they were carried
    each_open_face(axis, [&](std::size_t f, const FlowPlace& middle) {
      if (!once[f].whole) return;
      const FlowValue back = at_end_of_path(out, axis, f, middle, h_);
      if (!back.whole) return;
      corrected[f] = std::clamp(once[f].value + 0.5 * (carried[a][f] - back.value), once[f].low, once[f].high);
    });
    out[a].swap(corrected);
  }

  template <class Function>
  void each_open_face(int axis, const Function& function) const {
    const auto& kind = domain_.face[static_cast<std::size_t>(axis)];
    const int nx = grid_.faces(axis)[0], ny = grid_.faces(axis)[1], rows = ny * grid_.faces(axis)[2];
    each_block(
        team_, static_cast<std::size_t>(rows),
        [&](std::size_t begin, std::size_t end) {
          std::size_t f = begin * static_cast<std::size_t>(nx);
          for (int row = static_cast<int>(begin); row < static_cast<int>(end); ++row) {
            for (int i = 0; i < nx; ++i, ++f) {
              if (kind[f] == FaceKind::open) function(f, paths_.middle_of_face(axis, {i, row % ny, row / ny}));
            }
          }
        },
        rows_of_a_block);
  }

  // What is carried along an axis at the end of a path from the middle of a face, by the mid-point rule: with the
  // velocity half the time on. It is not whole where the path was cut short.
  FlowValue at_end_of_path(const FaceValues& carried, int axis, std::size_t f, const FlowPlace& middle,
                           double time) const {
    Vec<dim> u{};
    for (int b = 0; b < dim; ++b) {
      const auto c = static_cast<std::size_t>(b);
      u[c] = b == axis ? v_[c][f] : paths_.component(v_, b, middle);
    }
    FlowPlace half = middle, end = middle;
    paths_.follow(half, way(u, 0.5 * time));
    const bool uncut = paths_.follow(end, way(paths_.velocity(v_, half), time));
    FlowValue found = paths_.value(carried, axis, end);
    found.whole = found.whole && uncut;
    return found;
  }

  Vec<dim> way(Vec<dim> u, double time) const {
    for (std::size_t b = 0; b < dim; ++b) u[b] *= time / grid_.d[b];
    return u;
  }

  static constexpr std::size_t rows_of_a_block = 8;

  Team& team_;
  const FlowDomain& domain_;
  const StaggeredGrid& grid_;
  const FaceValues& v_;
  double h_;
  FlowPaths<dim> paths_;
};

template <int dim>
void carry_in(Team& team, const FlowDomain& domain, const FaceValues& v, const FaceValues& carried, double h,
              Advection advection, FaceValues& out) {
  const Carrier<dim> carrier(team, domain, v, h);
  advection == Advection::maccormack ? carrier.maccormack(carried, out) : carrier.semi_lagrangian(carried, out);
}

}  // namespace

void carry(Team& team, const FlowDomain& domain, const FaceValues& v, const FaceValues& carried, double h,
           Advection advection, FaceValues& out) {
  domain.grid.dim == 2 ? carry_in<2>(team, domain, v, carried, h, advection, out)
                       : carry_in<3>(team, domain, v, carried, h, advection, out);
}

void carry_velocity(Team& team, const FlowDomain& domain, const FaceValues& v, double h, Advection advection,
                    FaceValues& out) {
  carry(team, domain, v, v, h, advection, out);
}

}  // namespace tether::coupled
