// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "cases/run_deck.hpp"

namespace tether::cases {

/// The group $in of a box of square cells, with gravity of 1 and a record a step.
inline std::string box(int nx, int ny, double cell, double step, double tmax) {
  return fmt::format(
      "$in nx={}, ny={}, xleft=0., xright={:.17g}, ybot=0., ytop={:.17g}, tstep={:.17g}, tmax={:.17g}, gravc=-1., "
      "iout(33)=1, tiout(33)={:.17g} $\n",
      nx + 1, ny + 1, nx * cell, ny * cell, step, tmax, step);
}

/// The group $coupled of a liquid of density 1.
inline std::string liquid(const std::string& more) { return "$coupled density=1., liquid=.true., " + more + " $\n"; }

/// Half a wave in the box, as deep as half a wave.
struct Wave {
  double frequency = 0;  ///< over the exact one, less 1
  double damping = 0;    ///< of the amplitude in a period
};

/// The frequency is compared with that of I. Tadjbakhsh, J. Keller, J. Fluid Mech. 8 (1960) 442-451, without viscosity.
inline Wave wave(int cells, double amplitude, int dim, int periods, const std::string& more = "") {
  using std::numbers::pi;
  const double k = 2 * pi, depth = 0.5, cell = 1.0 / cells;
  const double steep = k * amplitude, w0 = std::sqrt(k * std::tanh(k * depth)), O = std::sqrt(std::tanh(k * depth));
  const double shift = (9 * std::pow(O, -7) - 12 * std::pow(O, -3) - 3 * O - 2 * std::pow(O, 5)) / 32;
  const double w = w0 * (1 + 0.5 * steep * steep * shift / O);
  const double period = 2 * pi / w;
  const std::string space = dim == 3 ? fmt::format("nz=5, zback=0., zfront={:.17g}, ", 4 * cell) : "";
  const DeckRun run = run_text(
      "wave", box(cells / 2, static_cast<int>(0.65 * cells), cell, 0.25 * std::sqrt(cell), (periods + 0.3) * period) +
                  liquid(fmt::format("{}liquid_below(1)='.5+{}*cos(2*pi*x)' {}", space, amplitude, more)));
  const auto t = run.history.column("time"), x = run.history.column("liquid_x");
  std::vector<double> zeros, peaks;
  double peak = 0;
  for (std::size_t i = 1; i < t.size(); ++i) {
    const double before = 0.25 - x[i - 1], now = 0.25 - x[i];
    if (before * now < 0) {
      zeros.push_back(t[i - 1] + (t[i] - t[i - 1]) * before / (before - now));
      if (peak > 0) peaks.push_back(peak);
      peak = 0;
    }
    peak = std::max(peak, std::abs(now));
  }
  const std::size_t count = std::min(zeros.size(), static_cast<std::size_t>(2 * periods)),
                    last = std::min(count, peaks.size()) - 1;
  return {static_cast<double>(count - 1) * pi / (zeros[count - 1] - zeros[0]) / w - 1,
          1 - std::pow(peaks[last] / peaks[1], 2.0 / static_cast<double>(last - 1))};
}

}  // namespace tether::cases
