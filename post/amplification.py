#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How long a step of the material point method may be, derived: python3 post/amplification.py.

Thesis chapter 8 in place of its Maple listing (A.4.14): points of one mass, one in each cell and all at the same place in
it, linear elastic in one dimension, c^2 = E/rho. N is the shape function of a cell's left node at its point: 1 at the
left side, 1/2 at the centre, 0 at the right side. Besides the thesis' amplification of one perturbed point, the growth of
waves (von Neumann), which the thesis names but does not carry out, and the limit of a bar of few cells between fixed
walls, which is what its numerical test has (8.5).
"""
from functools import lru_cache

import sympy

N, dt, dx, c, theta = sympy.symbols("N dt dx c theta", real=True)
C = sympy.symbols("C", positive=True)  # Courant number c dt/dx
w = sympy.symbols("w", real=True)  # 1 - cos theta
v = {k: sympy.Symbol(f"v_{k}".replace("-", "m"), real=True) for k in range(-2, 3)}  # of point p + k, at level L1

CENTRE, SIDE = sympy.Rational(1, 2), sympy.Integer(1)  # the other side, 0, has the same limits


def convected(k, velocities=v):
    """Velocity at node j + k mapped back from the points, masses alike: (8.11), (8.13). Point p + k is right of it."""
    return N * velocities[k] + (1 - N) * velocities[k - 1]


def moved(k):
    """Shape function of node j + k at point p + k after its step with the convected velocities: (8.27) to (8.29)."""
    return N - dt / dx * (N * convected(k) + (1 - N) * convected(k + 1))


def node_mass(k):
    """Of node j + k after the step, over a point's mass: (8.19)."""
    return moved(k) + 1 - moved(k - 1)


def stress(k):
    """Of point p + k over rho, from no stress: E/rho times the strain of one step, (8.8), (8.9)."""
    return c**2 * dt / dx * (convected(k + 1) - convected(k))


def next_velocity(velocities):
    """Velocity of point p after the second step, (8.7) with (8.10) to (8.29); `velocities` stand in for those at L1."""
    left = moved(0) / node_mass(0) * (stress(0) - stress(-1))
    right = (1 - moved(0)) / node_mass(1) * (stress(1) - stress(0))
    change = dt / dx * (left + right)
    return v[0] + change.subs({v[k]: value for k, value in velocities.items()})


@lru_cache
def braking():
    """f of (8.30), v' = v - c^2 (dt/dx)^2 f: the perturbed point alone moves, as far as it will. What Maple gave."""
    alone = next_velocity({k: 0 for k in v if k != 0})
    return sympy.factor((v[0] - alone) * (dx / (c * dt))**2)


@lru_cache
def amplification():
    """G(N, C) = v'/v of a small perturbation: (8.34) at the sides, (8.38) at the centre, and what lies between."""
    return sympy.expand(1 - C**2 * sympy.limit(braking() / v[0], v[0], 0))


def limit(place):
    """Largest C with |G| <= 1 at N = place: G falls from 1, so that -1 is the bound. (8.36), (8.41)"""
    (bound,) = [root for root in sympy.solve(sympy.Eq(amplification().subs(N, place), -1), C) if root.is_positive]
    return bound


@lru_cache
def wave_stiffness():
    """k(N, w), w = 1 - cos theta: a step with all points at N takes a wave exp(i theta p) by v += a sigma, then
    sigma += b v, a b = -k C^2. Its two growth factors have the product 1 and the sum 2 - k C^2: none is above 1 while
    k C^2 <= 4."""
    wave = {k: sympy.exp(sympy.I * theta * k) for k in v}
    strain_rate = convected(1, wave) - convected(0, wave)
    force = N * (1 - wave[-1]) + (1 - N) * (wave[1] - 1)
    stiffness = sympy.expand_trig(sympy.simplify(-(force * strain_rate).rewrite(sympy.cos)))
    return sympy.factor(sympy.expand(stiffness.subs(sympy.cos(theta), 1 - w)))


def wave_limit(place):
    """Largest C at N = place for which no wave grows; the stiffest has 0 <= w <= 2."""
    stiffness = wave_stiffness().subs(N, place)
    inside = [root for root in sympy.solve(sympy.diff(stiffness, w), w) if 0 <= root <= 2]
    return 2 / sympy.sqrt(max(stiffness.subs(w, at) for at in [*inside, 2]))


def bar_limit(place, cells):
    """The same for cells between fixed walls, which let theta = n pi/cells through, n = 1 .. cells - 1."""
    stiffness = [wave_stiffness().subs({N: place, w: 1 - sympy.cos(sympy.pi * n / cells)}) for n in range(1, cells)]
    return 2 / sympy.sqrt(max(sympy.N(k) for k in stiffness))


def text():
    places = {"left side, N = 1": SIDE, "centre, N = 1/2": CENTRE, "right side, N = 0": sympy.Integer(0)}
    lines = ["N: shape function of the left node at its point; C = c dt/dx, c^2 = E/rho", "",
             "One point of a row perturbed by v_0, the others at rest: v' = v_0 - c^2 (dt/dx)^2 f, (8.30)",
             f"  f = {braking()}", f"  small v_0: G = v'/v_0 = {amplification()}", "",
             "All points in waves exp(i theta p), w = 1 - cos(theta): stable while k C^2 <= 4",
             f"  k = {wave_stiffness()}", ""]
    for name, place in places.items():
        lines += [f"Points at the {name}",
                  f"  G = {amplification().subs(N, place)}, |G| <= 1 for dt <= {limit(place)} dx/c",
                  f"  no wave grows for dt <= {wave_limit(place)} dx/c,"
                  f" on five cells between fixed walls for dt <= {bar_limit(place, 5):.4f} dx/c"]
    return "\n".join(lines)


if __name__ == "__main__":
    print(text())
