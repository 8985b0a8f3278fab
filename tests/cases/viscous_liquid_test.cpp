// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <complex>

#include "cases/liquid_support.hpp"

// Viscous liquids with a surface, against exact solutions. Density and gravity are 1.

namespace tether::cases {
namespace {

using std::numbers::pi;

/// A wave on deep liquid has the rate s of (s + 2 nu k^2)^2 + w0^2 = 4 nu^2 k^4 sqrt(1 + s / (nu k^2)), H. Lamb,
/// Hydrodynamics, art. 349. That of a depth of half a wave has w0^2 = g k tanh k h, to well below what is gated.
std::complex<double> rate_of(double nu, double k, double w0) {
  std::complex<double> s(0, w0);
  const double by = nu * k * k;
  for (int i = 0; i < 100; ++i)
    s = std::complex<double>(0, 1) * std::sqrt(w0 * w0 - 4 * by * by * std::sqrt(1.0 + s / by)) - 2 * by;
  return s;
}

TEST(ViscousLiquid, WavesAreDampedAndSlowedDown) {
  const double k = 2 * pi, w0 = std::sqrt(k * std::tanh(k / 2)), period = 2 * pi / w0;
  const int periods = at_full_length() ? 5 : 3;
  for (const double nu : {2e-4, 1e-3}) {
    const std::complex<double> exact = rate_of(nu, k, w0);
    const double damping = 1 - std::exp(exact.real() * period), slower = exact.imag() / w0 - 1;
    const Wave found =
        wave(64, 0.01, 2, periods, fmt::format(", viscosity={}, side(1)='slip', 'slip', 'slip', 'slip'", nu));
    EXPECT_NEAR(found.damping / damping, 1, 0.03) << nu;
    EXPECT_NEAR(found.frequency, slower, 0.005) << nu;
  }
}

}  // namespace
}  // namespace tether::cases
