# SPDX-License-Identifier: GPL-3.0-or-later
"""The files of a run: that they are there, that they agree, and that they are the same again."""
import hashlib
import pathlib
import unittest

import netCDF4
import numpy

from program import DECKS, ROOT, ProgramTest, history, netcdf, records, sets, summary
from waiting import wait_until

BOXES = ROOT / "tests" / "thesis-boxes"

SUMMARY_KEYS = ["path", "steps", "points", "cells_active", "dx", "time_end", "dt_min", "cpu_seconds", "wall_seconds",
                "setup_cpu_seconds", "setup_wall_seconds", "threads", "ns_per_point_step", "peak_memory_mb",
                "energy_drift", "energy_lost", "energy_growth", "energy_rise", "mass_drift", "energy_step_largest"]
SCENE_COLUMNS = ["time", "dt", "energy_kinetic", "energy_strain", "energy_internal", "energy_potential", "energy_total",
                 "mass", "momentum_x", "momentum_y", "angular_momentum_z", "energy_transfer", "energy_walls",
                 "energy_integration"]
BODY_COLUMNS = ["body_x", "body_y", "body_vx", "body_vy", "body_mass"]

# Box 3, 6, 12 and 14 have their points in a box of their own; the others need none.
BOX_RUNS = [("box03_springmass.in", "box04_springmass.par"), ("box06_pendulum.in", "box07_pendulum.par"),
            ("box12_piston.in", "box13_piston.par"), ("box14_stability.in", "box14_stability.par"),
            ("box02_gasexp.in", None), ("box01_sod.in", None), ("box15_twobar.in", None)]

# A square of 6 x 6 points in cells of 1 that turns about its middle and is stretched; more than one point a cell, so
# that the order of rows is the order of sums.
TURNING_SQUARE = """a square that turns
$in
 nx=11, ny=11, igen=0,
 xleft=0.0, xright=10.0, ybot=0.0, ytop=10.0,
 tmax=1.0, tstep=5.d-3,
 wl=1, wr=1, wb=1, wt=1
$
"""


def turning_rows():
    """Its rows: a lattice about (5, 5), velocity (.3 (5 - y) + .1 x, .3 (x - 5))."""
    places = [3.75 + 0.5 * k for k in range(6)]
    return [f"{x} {y} {0.3 * (5 - y) + 0.1 * x} {0.3 * (x - 5)} 0.0 0.0 0.0" for y in places for x in places]


def same_bytes(one, other, name):
    return (one / name).read_bytes() == (other / name).read_bytes()


class Sod(ProgramTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.out = ProgramTest.shared_by(cls).run_ok(DECKS / "sod.in")

    def test_files(self):
        self.assertEqual(sorted(path.name for path in self.out.iterdir()),
                         ["deck.effective", "history.nc", "history.txt", "mesh.nc", "mesh.pvd", "messages.txt",
                          "particles.nc", "particles.pvd", "reference.txt", "summary.txt", "vtk"])

    def test_summary(self):
        told = summary(self.out)
        errors = [f"error_{name}" for name in ("density", "velocity", "pressure", "specific_energy")]
        more = ["points_by_lanes", "gases_apart", *errors, "compared_from", "compared_to"]
        self.assertEqual(list(told), SUMMARY_KEYS + more)
        # 50 cells of 9 points on either side, .143 / 1e-4 steps.
        self.assertEqual([told[key] for key in ("path", "steps", "points", "cells_active", "time_end", "mass_drift")],
                         ["mpm", "1430", "900", "100", "0.143", "0"])
        self.assertEqual(told["points_by_lanes"], told["points"])
        self.assertAlmostEqual(float(told["dt_min"]), 1e-4, delta=1e-12)
        for key in errors:
            self.assertTrue(0 < float(told[key]) < 0.1, key)

    def test_history_columns(self):
        columns = history(self.out)
        self.assertEqual(list(columns), SCENE_COLUMNS + [f"{name}_{b}" for name in BODY_COLUMNS for b in (1, 2)])
        self.assertEqual(columns["time"][0], 0)
        self.assertEqual(columns["time"][-1], 0.143)
        self.assertEqual(len(columns["time"]), 144)  # one each .001
        numpy.testing.assert_allclose(columns["time"], 0.001 * numpy.arange(144), rtol=0, atol=1e-12)

    def test_history_text_and_netcdf_are_equal(self):
        columns, variables = history(self.out), netcdf(self.out / "history.nc")
        found = {}
        for name, values in variables.items():
            if values.ndim == 1:
                found[name] = values
            elif values.dtype == float:
                found.update({f"{name}_{k + 1}": values[:, k] for k in range(values.shape[1])})
        self.assertEqual(set(found), set(columns))
        for name, values in columns.items():
            numpy.testing.assert_array_equal(values, found[name], err_msg=name)

    def test_netcdf_attributes(self):
        deck = (DECKS / "sod.in").read_text()
        for name in ("history.nc", "particles.nc", "mesh.nc"):
            with netCDF4.Dataset(self.out / name) as file, self.subTest(file=name):
                self.assertEqual(file.Conventions, "CF-1.10")
                self.assertIn("Sod's shock tube", file.title)
                self.assertIn("decks/sod.in --quiet --out", file.history)
                self.assertRegex(file.program, r"^tether \d+\.\d+\.\d+$")
                self.assertRegex(file.git_hash, r"^\w+")
                self.assertEqual(file.deck, deck)
                self.assertEqual(file.deck_sha256, hashlib.sha256(deck.encode()).hexdigest())
                for variable in file.variables.values():
                    if variable.dtype == float and "name" not in variable.name:
                        self.assertTrue(hasattr(variable, "units") or variable.name in file.dimensions, variable.name)

    def test_history_can_be_read_while_it_grows(self):
        with netCDF4.Dataset(self.out / "history.nc") as file:
            self.assertEqual(file.data_model, "NETCDF3_64BIT_OFFSET")
            self.assertTrue(file.dimensions["time"].isunlimited())

    def test_snapshots(self):
        points, grid = netcdf(self.out / "particles.nc"), netcdf(self.out / "mesh.nc")
        numpy.testing.assert_allclose(points["time"], [0, 0.0501, 0.1002, 0.143], rtol=0, atol=1e-12)
        numpy.testing.assert_allclose(grid["time"], [0, 0.05, 0.1, 0.143], rtol=0, atol=1e-12)
        self.assertEqual(points["x"].shape, (4, 900))
        self.assertEqual(grid["mass"].shape, (4, 2, 101))
        mass = history(self.out)["mass"][0]
        numpy.testing.assert_allclose(grid["mass"].sum(axis=(1, 2)), mass, rtol=1e-12)
        numpy.testing.assert_allclose(points["mass"].sum(axis=1), mass, rtol=1e-12)

    def test_messages_hold_the_deck_s_warnings(self):
        messages = (self.out / "messages.txt").read_text()
        self.assertIn("sod.in:12:22: remark: tiout is set for outputs that are off", messages)


class Again(ProgramTest):
    def assert_effective_deck_repeats(self, out):
        again = self.run_ok(out / "deck.effective", out=f"{out.name}-again")
        self.assertTrue(same_bytes(out, again, "history.txt"))
        self.assertTrue(same_bytes(out, again, "deck.effective"))

    def test_effective_decks(self):
        for name, options in (("sod", []), ("spring-mass", []), ("pendulum-40", sets(in__tmax=0.2)),
                              ("gas-expansion", []), ("piston-m01", []),
                              ("stability-centre", ["--particles", ROOT / "particles/stability-side.par"])):
            with self.subTest(deck=name):
                self.assert_effective_deck_repeats(self.run_ok(DECKS / f"{name}.in", *options, out=name))

    def test_the_thesis_boxes_as_printed(self):
        for deck, particles in BOX_RUNS:
            with self.subTest(box=deck):
                options = ["--particles", BOXES / particles] if particles else []
                out = self.run_ok(BOXES / deck, *options, out=pathlib.Path(deck).stem)
                self.assert_effective_deck_repeats(out)

    def test_a_value_set_on_the_command_line_lasts(self):
        out = self.run_ok(DECKS / "sod.in", *sets(in__tmax=0.0105, in__tstep=2e-4, in__dtmax=2e-4))
        again = self.run_ok(out / "deck.effective", out="again")
        self.assertEqual(history(again)["time"][-1], 0.0105)
        self.assertEqual(summary(again)["steps"], "53")  # .0105 / .0002 = 52.5

    def test_two_runs_are_the_same(self):
        for name, options in (("sod", []), ("pendulum-40", sets(in__tmax=0.2)), ("piston-m1", [])):
            with self.subTest(deck=name):
                one, other = (self.run_in(self.folder / which / name, DECKS / f"{name}.in", *options)
                              for which in ("one", "other"))
                self.assertTrue(same_bytes(one, other, "history.txt"))
                self.assertTrue(same_bytes(one, other, "history.nc"))
                self.assert_same_variables(one / "particles.nc", other / "particles.nc")

    def run_in(self, folder, *words):
        """A run from its own folder, so that both runs are the same command line."""
        folder.mkdir(parents=True)
        self.expect(0, *words, "--out", "out", folder=folder)
        return folder / "out"

    def assert_same_variables(self, one, other):
        first, second = netcdf(one), netcdf(other)
        self.assertEqual(first.keys(), second.keys())
        for name in first:
            numpy.testing.assert_array_equal(first[name], second[name], err_msg=name)


class OrderOfRows(ProgramTest):
    def assert_order_does_not_count(self, deck, header, rows, order):
        """The last fields of a run with `rows` and of one with rows[order], to 1e-12 of each field's largest number."""
        plain = self.write("plain.par", "\n".join(header + rows) + "\n")
        moved = self.write("moved.par", "\n".join(header + [rows[k] for k in order]) + "\n")
        one = netcdf(self.run_ok(deck, "--particles", plain, out="plain") / "particles.nc")
        other = netcdf(self.run_ok(deck, "--particles", moved, out="moved") / "particles.nc")
        for name in set(one) - {"time", "id"}:
            expected = one[name][-1][order]
            numpy.testing.assert_allclose(other[name][-1], expected, rtol=0, atol=1e-12 * abs(expected).max(),
                                          err_msg=name)
        self.assertGreater(abs(one["sxx"][-1]).max(), 0)

    def test_reversed_bar(self):
        lines = (ROOT / "particles/stability-centre.par").read_text().splitlines()
        self.assert_order_does_not_count(DECKS / "stability-centre.in", lines[:5], lines[5:10], [4, 3, 2, 1, 0])

    def test_shuffled_square(self):
        header = ["1.0", "1.0d3,0.3,0.0,0.0,0.0,0.0,0.0", "3,3,3,2", "36", "36,4"]
        deck = self.write("square.in", TURNING_SQUARE)
        self.assert_order_does_not_count(deck, header, turning_rows(), [(k * 7) % 36 for k in range(36)])


class Conserved(ProgramTest):
    def test_two_bars(self):
        """No wall is reached: momentum to rounding, mass to the last bit."""
        out = self.run_ok(DECKS / "two-bar-stick.in")
        columns = history(out)
        momentum = 1.25 * 4.5 * 2  # a bar of density 1 at velocity 2
        numpy.testing.assert_allclose(columns["momentum_x"], momentum, rtol=1e-12)
        numpy.testing.assert_allclose(columns["momentum_y"], 0, rtol=0, atol=1e-12 * momentum)
        self.assertEqual(numpy.unique(columns["mass"]).tolist(), [11.25])
        self.assertEqual(columns["time"][-1], 0.501)
        self.assertGreater(columns["body_vx_2"][-1], 0.1)  # they have met

    def test_mass_in_every_kind_of_scene(self):
        for name in ("sod", "piston-m1", "spring-mass", "gas-expansion"):
            with self.subTest(deck=name):
                out = self.run_ok(DECKS / f"{name}.in", out=name)
                self.assertEqual(len(numpy.unique(history(out)["mass"])), 1)
                self.assertEqual(summary(out)["mass_drift"], "0")


class AtRest(ProgramTest):
    def test_what_starts_without_energy_has_no_growth(self):
        """It was 2e23 of this: the largest energy over rounding."""
        folder = self.run_ok(DECKS / "l-block.in", *sets(in__tmax=0.05, in__tstep=0.01))
        self.assertNotIn("energy_growth", summary(folder))
        self.assertIn("energy_growth", summary(self.run_ok(DECKS / "spring-mass.in", *sets(in__tmax=0.05), out="falls")))


class WhileItRuns(ProgramTest):
    def test_another_process_reads_a_growing_history(self):
        out = self.folder / "out"
        process = self.start(DECKS / "pendulum-320.in", "--quiet", "--out", out, *sets(in__tmax=1000))
        lengths = [0]
        for _ in range(4):
            wait_until(lambda: records(out) > lengths[-1], "one more record", process)
            lengths.append(self.length_of_whole_records(out))
        self.assertEqual(lengths, sorted(set(lengths)))

    def length_of_whole_records(self, out):
        """The number of records that are seen, each of which must be complete."""
        columns = netcdf(out / "history.nc")
        length = len(columns["time"])
        numpy.testing.assert_allclose(columns["time"], 0.01 * numpy.arange(length), rtol=0, atol=1e-9)
        self.assertTrue(numpy.all(columns["mass"] == columns["mass"][0]) and numpy.all(columns["mass"] > 3.3))
        return length

    def test_a_second_run_replaces_the_first(self):
        out = self.run_ok(DECKS / "sod.in")
        self.assertTrue((out / "mesh.nc").exists())
        self.expect(0, DECKS / "stability-centre.in", "--quiet", "--out", out)
        self.assertFalse((out / "mesh.nc").exists())
        self.assertFalse((out / "reference.txt").exists())
        self.assertEqual(history(out)["time"][-1], 0.03)


if __name__ == "__main__":
    unittest.main()
