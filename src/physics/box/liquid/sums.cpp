// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/liquid/sums.hpp"

#include "base/numbers.hpp"
#include "physics/box/liquid/facets.hpp"

namespace tether::liquid {

LiquidSums sums_of(const Particles& particles, int dim, double density, const Vec<3>& gravity) {
  LiquidSums sums;
  sums.particles = particles.size();
  for (std::size_t k = 0; k < particles.size(); ++k) {
    const Vec<3> x = place_of(particles, dim, k);
    double square = 0;
    for (std::size_t a = 0; a < at(dim); ++a) {
      square += particles.v[a][k] * particles.v[a][k];
      sums.middle[a] += particles.volume[k] * x[a], sums.velocity[a] += particles.volume[k] * particles.v[a][k];
    }
    sums.volume += particles.volume[k];
    sums.kinetic += 0.5 * density * particles.volume[k] * square;
    sums.gravity -= density * particles.volume[k] * dot(gravity, x);
  }
  for (Vec<3>* mean : {&sums.middle, &sums.velocity}) {
    for (double& value : *mean) value = sums.volume > 0 ? value / sums.volume : 0;
  }
  return sums;
}

void add_surface(const Surface& surface, LiquidSums& sums) {
  const int dim = surface.room.grid.dim;
  const auto add_whole = [&](double volume, double open) { sums.enclosed += volume * open; };
  SurfaceLattice(surface).each(add_whole, [&](const Simplex& simplex) {
    const Cut cut = cut_of(simplex, dim);
    sums.enclosed += cut.volume * simplex.open;
    for (std::size_t k = 0; k < cut.facets; ++k) sums.area += area_of(cut.facet[k], dim) * simplex.open;
  });
}

}  // namespace tether::liquid
