// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/fem/flow_stream.hpp"

namespace tether::fem {

StreamFunction::StreamFunction(const FlowElements& elements) : elements_(elements), A_(elements.laplacian()) {
  std::vector<std::uint8_t> held(static_cast<std::size_t>(A_.n), 0);
  held[0] = 1;
  hold(A_, held, 1);
  solver_.factorise(A_, Definite::positive);
}

std::vector<double> StreamFunction::of(std::span<const double> v) const {
  std::vector<double> psi = elements_.stream_source(v);
  psi[0] = 0;
  solver_.solve(psi, psi);
  return psi;
}

}  // namespace tether::fem
