#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes cases.txt: the cases by which `tether DECK --auto TOL` is judged, each with its exact answer.

Twenty scenes whose answers are known, each by a grid that is not aligned, another material and another size. Answers
are those of what a deck describes as cells and steps fall to zero.
"""

import math
import pathlib

from answers import (bar_let_go, layered_column, pendulum, riemann_kinetic_energy, spun_free, swung, thick_ring)

HERE = pathlib.Path(__file__).resolve().parent
FALL = "first(body_y_1) - last(body_y_1)"
CASES = []


def case(name, deck, quantity, exact, *sets):
    CASES.append((name, deck, quantity, exact, sets))


def bars():
    """A bar that hangs and is let go, after a period and a quarter."""
    for path in ("mpm", "fem", "coupled"):
        def add(kind, length, modulus, density, *sets):
            c = math.sqrt(modulus / density)
            time = 5 * length / c
            case(f"bar_{path}_{kind}", "decks/paths/bar.in", FALL, bar_let_go(length, c, 1e-3, time),
                 f"in.path='{path}'", f"in.tmax={time:.15g}", *sets)

        grid = ("in.ybot=-.237", "in.ny=27", "in.xleft=-.013", "in.nx=4") if path == "mpm" else (
            "mesh.cells(2,1)=7", "in.tstep=2.3e-3")
        add("grid", 1, 1e6, 1000, *grid)
        add("material", 1, 3.3e6, 700, "reg.matr(1,1)=3.3e6", "reg.densir(1)=700.", "in.ny=25", "in.nx=3",
            "mesh.cells(2,1)=10")
        add("size", 0.62, 1e6, 1000, "reg.yvi(1,1)=.38,.38,1.,1.", "mesh.cells(2,1)=8",
            "points.tracked_at(1,1)=.05,.38")


def columns():
    """A column of compressible fluid, or of elements, under a piston, let go."""
    for path in ("mpm", "fem", "coupled"):
        region = 1 if path == "mpm" else 3

        def add(kind, lengths, densities, moduli, time, *sets):
            exact = layered_column(lengths, densities, moduli, 1e-2, lengths[0] + lengths[1] / 2, time, 1500)
            case(f"column_{path}_{kind}", "decks/paths/piston.in", "first(point_y_1) - last(point_y_1)", exact,
                 f"in.path='{path}'", f"in.tmax={time:.15g}", *sets)

        grid = ("in.ytop=1.53", "in.ny=70", "in.nx=3") if path == "mpm" else (
            "mesh.cells(2,3)=7", "mesh.cells(2,2)=2", "in.tstep=4.3e-3")
        add("grid", (1, 0.2), (1000, 5000), (1e6, 1e8), 0.3, *grid)
        add("material", (1, 0.2), (1500, 3000), (2e6, 1e8), 0.2, f"reg.densir({region})=1500.", "reg.densir(2)=3000.",
            f"reg.matr(1,{region})=2.e6", "in.ny=61", "in.nx=3", "mesh.cells(2,3)=10")
        add("size", (0.8, 0.3), (1000, 5000), (1e6, 1e8), 0.3, f"reg.yvi(1,{region})=0.,0.,.8,.8",
            "reg.yvi(1,2)=.8,.8,1.1,1.1", "points.tracked_at(1,1)=.05,.95", "in.ny=61", "in.nx=3", "mesh.cells(2,3)=9",
            "mesh.cells(2,2)=3")


def pendulums():
    """A mass on a string, let go at 18.4 degrees. Points and bars stand at the middles of the curve's parts, so that in
    the end the string is as long as the curve; the strip of elements ends at the middle of its block."""
    curve = math.hypot(0.33333 - 0.098523228, 1 - 0.295569620)
    strip = math.hypot(0.33333 - 0.1, 1 - 0.3)
    angle = math.atan2(0.33333 - 0.1, 0.7)
    for path in ("mpm", "bars", "fem"):
        length = strip if path == "fem" else curve

        def add(kind, gravity, mass, stiffness, *sets):
            exact = pendulum(length, mass * gravity / stiffness, gravity, angle, mass, 0.0175 * length)
            case(f"pendulum_{path}_{kind}", "tests/auto/decks/pendulum.in", "period(point_x_1, .33333)", exact,
                 f"in.path='{path}'", f"in.gravc={-gravity:g}", *sets)

        grid = {"mpm": ("in.xleft=-.021", "in.ytop=1.043", "in.nx=17", "in.ny=24", "membrane.count(1)=47"),
                "bars": ("membrane.count(1)=47",), "fem": ("mesh.cells(1,1)=5", "in.tstep=7.e-3")}[path]
        add("grid", 20, 3.3, 1.75e5, *grid)
        add("gravity", 9.81, 3.3, 1.75e5, "in.tmax=2.6")
        heavy = ("membrane.heavy(2,1)=8.1", "membrane.young(1)=2.e6", "reg.densir(2)=81000.", "reg.matr(1,1)=3.5e7",
                 "reg.matr(1,3)=3.5e7")
        add("mass", 20, 8.1, 3.5e5, *heavy)


def two_bars():
    """Two equal bars that meet end on swap their velocities."""
    for path in ("mpm", "fem"):
        def add(kind, *sets):
            case(f"two_bars_{path}_{kind}", "decks/paths/two-bar.in",
                 "(last(body_vx_2) - last(body_vx_1))/first(body_vx_1)", 1.0, f"in.path='{path}'", *sets)

        add("grid", *(("in.xleft=-.07", "in.nx=24", "in.ny=24") if path == "mpm" else
                      ("mesh.cells(1,1)=7", "mesh.cells(1,2)=6", "in.tstep=3.1e-4")))
        add("material", "reg.matr(1,1)=3.e5", "reg.matr(1,2)=3.e5", "reg.densir(1)=2.", "reg.densir(2)=2.")
        add("size", "reg.xvi(1,1)=1.4,2.25,2.25,1.4", "reg.xvi(1,2)=2.75,3.6,3.6,2.75", "reg.vrx(1)=3.")


def pistons():
    """A block on a spring in a channel: the water in it moves along."""
    for flow in ("grid", "mesh"):
        def add(kind, width, height, density, water, *sets):
            mass = density * width * height + water * height * (1 - width)
            case(f"piston_{flow}_{kind}", "decks/coupled-piston.in", "period(body_vx_1, 0)",
                 2 * math.pi * math.sqrt(mass / 9376.03), f"coupled.flow='{flow}'", "in.tmax=4.", *sets)

        add("grid", 0.1, 0.25, 500, 1000, *(("in.nx=24", "in.ny=7") if flow == "grid" else ("coupled.size=.17",)))
        add("material", 0.1, 0.25, 2000, 800, "reg.densir(1)=2000.", "coupled.density=800.")
        add("size", 0.2, 0.2, 500, 1000, "reg.xvi(1,1)=.4,.6,.6,.4", "reg.yvi(1,1)=0.,0.,.2,.2", "in.ytop=.2",
            "in.nx=31", "in.ny=7")


def elements():
    """A ring under a pressure within, and a bar that vibrates."""
    out = "last(point_x_1) - first(point_x_1)"
    ring = "tests/auto/decks/ring.in"
    case("ring_grid", ring, out, thick_ring(1, 2, 1e-3, 1e3, 0.3), "mesh.cells(1:2,1)=3,5")
    case("ring_material", ring, out, thick_ring(1, 2, 1e-3, 2e4, 0.45), "reg.matr(1:2,1)=2.e4,.45")
    case("ring_size", ring, out, thick_ring(1, 3, 1e-3, 1e3, 0.3), "reg.xvi(1,1)=1.,3.,0.,0.",
         "reg.yvi(1,1)=0.,0.,3.,1.")
    bar = "decks/bar-vibration.in"
    case("vibration_grid", bar, "period(point_x_1, 1)", 4.0, "mesh.cells(1,1)=7", "in.tstep=.09")
    case("vibration_material", bar, "period(point_x_1, 1)", 4 / math.sqrt(2.7 / 0.6), "reg.matr(1,1)=2.7",
         "reg.densir(1)=.6", "mesh.cells(1,1)=10")
    case("vibration_size", bar, "period(point_x_1, 1.4)", 4 * 1.4, "reg.xvi(1,1)=0.,1.4,1.4,0.",
         "points.tracked_at(1,1)=1.4,.05", "mesh.cells(1,1)=9", "in.tstep=.04")


def flows():
    """Vortices that viscosity stops, and a channel."""
    decay = "tests/auto/decks/decay.in"
    lost = 4 * math.pi**2 * 0.02
    case("decay_grid", decay, "last(energy_kinetic)", 0.25 * math.exp(-lost), "mesh.cells(1:2,1)=7,9", "in.tstep=.125")
    case("decay_material", decay, "last(energy_kinetic)", 2.5 * 0.25 * math.exp(-lost), "reg.densir(1)=2.5",
         "reg.matr(1,1)=.05")
    case("decay_time", decay, "last(energy_kinetic)", 0.25 * math.exp(-2 * lost), "in.tmax=2.")
    channel = "tests/auto/decks/channel.in"
    case("channel_grid", channel, "last(probe_vx_1)", 0.1 / (8 * 0.05), "mesh.cells(1:2,1)=7,6")
    case("channel_material", channel, "last(probe_vx_1)", 0.3 / (8 * 0.2), "reg.matr(1,1)=.2", "flow.bx='.3'")
    case("channel_size", channel, "last(probe_vx_1)", 0.1 * 1.6**2 / (8 * 0.05), "reg.yvi(1,1)=0.,0.,1.6,1.6",
         "in.ytop=1.6", "flow.probe(1:2,1)=1.,.8")


def rigid_bodies():
    """A T that spins freely, and a plate that swings."""
    tee = [((-1.5, 0, -0.25), (-0.25, 0.5, 0.25), 1), ((-0.25, 0, -0.25), (0.25, 0.5, 0.25), 1),
           ((0.25, 0, -0.25), (1.5, 0.5, 0.25), 1), ((-0.25, -1.5, -0.25), (0.25, 0, 0.25), 1)]

    def free(kind, omega, time, *sets):
        exact = spun_free(tee, omega, (0.01, 0, 0), (1.5, 0.5, 0), time)[0]
        case(f"spin_{kind}", "decks/rigid-free.in", "last(point_x_2)", exact, f"in.tmax={time:g}",
             "rigid.omega=" + ",".join(f"{w:g}" for w in omega), *sets)

    free("grid", (0.01, 1, 0.01), 20, "in.tstep=.33", "in.tiout(33)=20.")
    free("speed", (0.3, 1.7, -0.2), 8, "in.tstep=.1", "in.tiout(33)=8.")
    free("time", (0.01, 1, 0.01), 33, "in.tstep=.2", "in.tiout(33)=33.")
    swing, down = "tests/auto/decks/swing.in", "last(point_y_1)"
    case("swing_grid", swing, down, swung(1, 0.2, 0.5, 9.81, 2.0, (0.6, 0.5)), "in.tstep=.09")
    case("swing_gravity", swing, down, swung(1, 0.2, 0.5, 3.7, 3.1, (0.6, 0.5)), "in.gravc=-3.7", "in.tmax=3.1",
         "in.tstep=.1")
    case("swing_size", swing, down, swung(1, 0.3, 0.75, 9.81, 2.0, (0.9, 0.5)), "mesh.z(1:2,1)=.6,.9",
         "mesh.tracked_z(1)=.9", "in.tstep=.1")


def tubes():
    """Sod's tube: the energy of motion."""
    deck, kinetic = "decks/sod.in", "last(energy_kinetic)"
    case("sod_grid", deck, kinetic, riemann_kinetic_energy((1, 1), (0.125, 0.1), 1.4, 0.143, 0.01), "in.nx=87",
         "mpm.method='robust'")
    case("sod_gas", deck, kinetic, riemann_kinetic_energy((1, 0.6667 * 2.5), (0.2, 0.6667 * 0.4), 1.6667, 0.1, 0.01),
         "in.tmax=.1", "fluid.gm1=.6667", "reg.densir(2)=.2", "mpm.method='robust'")
    case("sod_time", deck, kinetic, riemann_kinetic_energy((1, 1), (0.125, 0.1), 1.4, 0.09, 0.01), "in.tmax=.09",
         "in.nx=61", "mpm.method='robust'")


def make():
    """Fills CASES."""
    for add in (bars, columns, pendulums, two_bars, pistons, elements, flows, rigid_bodies, tubes):
        add()


def main():
    make()
    lines = ["# name | deck | quantity | exact | what is set, written by write_cases.py"]
    for name, deck, quantity, exact, sets in CASES:
        lines.append(" | ".join((name, deck, quantity, f"{exact:.12g}", *sets)))
    (HERE / "cases.txt").write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
