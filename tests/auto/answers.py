# SPDX-License-Identifier: GPL-3.0-or-later
"""The exact answers of the cases by which `--auto` is judged, from formulas and differential equations alone."""

import math


def bar_let_go(length, c, gravity, time):
    """How far the centre of mass of a hanging bar is down that is let go at t = 0: a sum over its modes [length]."""
    down = 0.0
    for n in range(2000):
        k = (n + 0.5) * math.pi
        down += 2 / k**4 * (1 - math.cos(k * c * time / length))
    return gravity * length**2 / c**2 * down


def layered_column(lengths, densities, moduli, gravity, place, time, modes=4000):
    """How far a place of two layers is down that stand on a floor and are let go at t = 0 [length].

    Displacements are sums of modes: sin(k1 y) in the lower layer, B cos(k2 (H - y)) in the upper, whose end is free.
    """
    (l1, l2), (r1, r2) = lengths, densities
    c1, c2 = (math.sqrt(e / r) for e, r in zip(moduli, densities))
    height = l1 + l2

    def lacking(w):  # of the balance of forces between the layers, times both cosines: it has no poles
        a, b = w * l1 / c1, w * l2 / c2
        return r1 * c1 * math.cos(a) * math.cos(b) - r2 * c2 * math.sin(a) * math.sin(b)

    down, found, w = 0.0, 0, 0.0
    step = 0.05 / (l1 / c1 + l2 / c2)
    before = lacking(0.0)
    while found < modes:
        w += step
        now = lacking(w)
        if before * now < 0:
            low, high = w - step, w
            for _ in range(80):
                middle = 0.5 * (low + high)
                low, high = (middle, high) if lacking(low) * lacking(middle) > 0 else (low, middle)
            down += share_of_mode(0.5 * (low + high), l1, l2, r1, r2, c1, c2, height, place, gravity, time)
            found += 1
        before = now
    return down


def share_of_mode(w, l1, l2, r1, r2, c1, c2, height, place, gravity, time):
    k1, k2 = w / c1, w / c2
    a, b = k1 * l1, k2 * l2
    upper = math.sin(a) / math.cos(b)
    weight = r1 * (1 - math.cos(a)) / k1 + r2 * upper * math.sin(b) / k2
    mass = r1 * (l1 / 2 - math.sin(2 * a) / (4 * k1)) + r2 * upper**2 * (l2 / 2 + math.sin(2 * b) / (4 * k2))
    shape = math.sin(k1 * place) if place <= l1 else upper * math.cos(k2 * (height - place))
    return gravity * weight / mass * shape * (1 - math.cos(w * time)) / w**2


def agm(a, b):
    while abs(a - b) > 1e-15 * a:
        a, b = 0.5 * (a + b), math.sqrt(a * b)
    return a


def pendulum(length, stretch, gravity, angle, mass, of_string):
    """The period of a point mass on a string whose own mass is spread along it, let go at an angle [time]."""
    reach = length * (1 + stretch)
    inertia = (mass + of_string / 3) * reach**2
    moment = (mass + of_string / 2) * gravity * reach
    return 2 * math.pi * math.sqrt(inertia / moment) / agm(1, math.cos(angle / 2))


def thick_ring(inner, outer, pressure, modulus, poisson):
    """How far the inner side of a ring under a pressure within goes out, in plane strain (Lame) [length]."""
    part = pressure * inner**2 / (outer**2 - inner**2)
    return (1 + poisson) / modulus * part * ((1 - 2 * poisson) * inner + outer**2 / inner)


def riemann_kinetic_energy(left, right, gamma, time, height):
    """The kinetic energy of a gas in a tube of this height after its wall has gone: (density, pressure) on both sides,
    which have no velocity, with a rarefaction to the left and a shock to the right [energy]."""
    (rl, pl), (rr, pr) = left, right
    cl = math.sqrt(gamma * pl / rl)

    def velocities(p):
        fan = 2 * cl / (gamma - 1) * (1 - (p / pl) ** ((gamma - 1) / (2 * gamma)))
        shock = (p - pr) * math.sqrt(2 / ((gamma + 1) * rr * (p + (gamma - 1) / (gamma + 1) * pr)))
        return fan, shock

    low, high = pr, pl
    for _ in range(200):
        p = 0.5 * (low + high)
        fan, shock = velocities(p)
        low, high = (p, high) if fan > shock else (low, p)
    u = velocities(p)[0]
    r_fan = rl * (p / pl) ** (1 / gamma)
    ratio = (gamma - 1) / (gamma + 1)
    r_shock = rr * (p / pr + ratio) / (ratio * p / pr + 1)
    speed = u * r_shock / (r_shock - rr)
    head, tail = -cl, u - math.sqrt(gamma * p / r_fan)
    energy, n = 0.0, 20000  # Simpson's rule over the fan
    for k in range(n + 1):
        s = head + (tail - head) * k / n
        v = 2 / (gamma + 1) * (cl + s)
        density = rl * (2 / (gamma + 1) - ratio / cl * s) ** (2 / (gamma - 1))
        energy += (1 if k in (0, n) else 4 if k % 2 else 2) * 0.5 * density * v * v
    energy *= (tail - head) / (3 * n)
    energy += 0.5 * u * u * (r_fan * (u - tail) + r_shock * (speed - u))
    return energy * time * height

def boxes_about(boxes):
    """Mass, centre and inertia about it of boxes (low, high, density): inertia along the axes of the box system."""
    parts = []
    for low, high, density in boxes:
        sides = [h - l for l, h in zip(low, high)]
        mass = density * sides[0] * sides[1] * sides[2]
        parts.append((mass, [0.5 * (l + h) for l, h in zip(low, high)], sides))
    mass = sum(m for m, _, _ in parts)
    centre = [sum(m * c[a] for m, c, _ in parts) / mass for a in range(3)]
    inertia = [[0.0] * 3 for _ in range(3)]
    for m, c, sides in parts:
        d = [c[a] - centre[a] for a in range(3)]
        for a in range(3):
            others = sum(sides[b] ** 2 for b in range(3) if b != a) / 12
            inertia[a][a] += m * (others + sum(d[b] ** 2 for b in range(3) if b != a))
            for b in range(3):
                if b != a:
                    inertia[a][b] -= m * d[a] * d[b]
    return mass, centre, inertia


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def turned(R, v):
    return [sum(R[i][j] * v[j] for j in range(3)) for i in range(3)]


def spun_free(boxes, omega, velocity, place, time, steps=20000):
    """Where a place of a free rigid body is after a time: Euler's equations in principal axes, which the boxes' must
    be, by Runge and Kutta's fourth order."""
    _, centre, inertia = boxes_about(boxes)
    I = [inertia[a][a] for a in range(3)]
    assert all(abs(inertia[a][b]) < 1e-12 for a in range(3) for b in range(3) if a != b)
    arm = [p - c for p, c in zip(place, centre)]

    def rates(state):
        R, w = state
        dw = [((I[(a + 1) % 3] - I[(a + 2) % 3]) * w[(a + 1) % 3] * w[(a + 2) % 3]) / I[a] for a in range(3)]
        columns = [cross(w, [R[i][j] for j in range(3)]) for i in range(3)]  # rows of R, in the body's frame
        return [[-x for x in row] for row in columns], dw

    def moved(state, rate, h):
        R, w = state
        return ([[R[i][j] + h * rate[0][i][j] for j in range(3)] for i in range(3)],
                [w[a] + h * rate[1][a] for a in range(3)])

    state = ([[1.0 if i == j else 0.0 for j in range(3)] for i in range(3)], list(omega))
    h = time / steps
    for _ in range(steps):
        k1 = rates(state)
        k2 = rates(moved(state, k1, h / 2))
        k3 = rates(moved(state, k2, h / 2))
        k4 = rates(moved(state, k3, h))
        for rate, part in ((k1, 1), (k2, 2), (k3, 2), (k4, 1)):
            state = moved(state, rate, h * part / 6)
    at = turned(state[0], arm)
    return [c + v * time + x for c, v, x in zip(centre, velocity, at)]


def swung(side, thickness, middle, gravity, time, arm, steps=20000):
    """The angle of a square plate that swings about a level line through a point of its axis: its axis is let go level;
    returns the height of a place (along the axis, above it at the start)."""
    inertia = (side**2 + thickness**2) / 12 + middle**2
    pull = gravity * middle / inertia
    a, w, h = 0.0, 0.0, time / steps
    for _ in range(steps):
        k1 = (w, pull * math.cos(a))
        k2 = (w + h / 2 * k1[1], pull * math.cos(a + h / 2 * k1[0]))
        k3 = (w + h / 2 * k2[1], pull * math.cos(a + h / 2 * k2[0]))
        k4 = (w + h * k3[1], pull * math.cos(a + h * k3[0]))
        a += h / 6 * (k1[0] + 2 * k2[0] + 2 * k3[0] + k4[0])
        w += h / 6 * (k1[1] + 2 * k2[1] + 2 * k3[1] + k4[1])
    return -arm[0] * math.sin(a) + arm[1] * math.cos(a)
