# SPDX-License-Identifier: GPL-3.0-or-later
"""What `--auto` leaves out of a model, and what stays because it counts."""
import pathlib
import re
import tempfile
import unittest

from full_length import FULL
from program import run
from waiting import SLOWER

BLOCK = ("in.tmax=8.", "auto.quantity='last(point_y_1)'")
PISTON = ("in.tmax=1.", "auto.quantity='max(body_x_1) - min(body_x_1)'")
GAS = ("mpm.method='robust'", "reference.solution=''", "auto.quantity='last(energy_kinetic)'")
GROWTH = ("in.tmax=.4", "mpm.method='robust'", "reference.solution=''", "auto.quantity='last(energy_internal)'")
RISE = ("fem.law(1)='svk'", "auto.quantity='last(point_y_1) - first(point_y_1)'")
DEFORMATION, TOGETHER, FLUID = "deformation (one rigid body in its place)", "solving fluid and bodies together", "the fluid"
VISCOSITY = "viscosity of the gas"

# deck, tolerance, values, what is left out, what is kept
MODELS = {
    "a stiff block that flies is rigid": ("decks/l-block.in", 0.02,
                                          (*BLOCK, *(f"reg.matr(1,{r})=5.e9,.3" for r in (1, 2, 3))), (DEFORMATION,), ()),
    "a soft one is not": ("decks/l-block.in", 0.1, ("in.tmax=4.", "auto.quantity='last(point_y_1)'"), (), (DEFORMATION,)),
    "a heavy bar in air is split from it": (
        "decks/paths/bar.in", 0.02, ("in.path='coupled'", "auto.quantity='first(body_y_1) - last(body_y_1)'"),
        (TOGETHER, FLUID), ()),
    "a light block in water is not": ("decks/coupled-piston.in", 0.02, PISTON, (), (TOGETHER, FLUID)),
    "water is thin, and heavier than the block": ("decks/coupled-piston.in", 0.06, (*PISTON, "coupled.viscosity=1.e-4"),
                                                  ("viscosity of the fluid",), (TOGETHER, FLUID)),
    "thin gas": ("decks/sod.in", 0.03, (*GAS, "fluid.mu=1.e-9"), (VISCOSITY, "rows of points that are alike"),
                 ("artificial viscosity",)),
    "thick gas": ("decks/sod.in", 0.03, (*GAS, "fluid.mu=3.e-3"), (), (VISCOSITY,)),
    "a beam that bends little": ("decks/bending.in", 0.03, RISE, ("large strains",), ("elements of order 2",)),
    "a beam that bends far": ("decks/bending.in", 0.03, (*RISE, "fem.load(2,1)=1000."), (), ("large strains",)),
    "a membrane in thin air": ("decks/membrane-expansion-1.in", 0.1, (*GROWTH, "fluid.pambient=.01"),
                               ("pressure outside", VISCOSITY), ()),
    "a membrane in thick air": ("decks/membrane-expansion-1.in", 0.1, (*GROWTH, "fluid.pambient=50."),
                                (VISCOSITY,), ("pressure outside",)),
    "a pendulum of points, by elements": (
        "tests/auto/decks/pendulum.in", 0.02,
        ("auto.quantity='period(point_x_1, .33333)'", f"auto.budget={20 * SLOWER}"),  # several times what the pair takes
        ("material points",), ()),
    "bars that meet": ("decks/paths/two-bar.in", 0.1, ("auto.quantity='last(body_vx_2)'",), (), ("contact between bodies",)),
    "bars that have not met": ("decks/paths/two-bar.in", 0.03,
                               ("in.tmax=.1", "in.nx=81", "in.ny=81", "auto.quantity='last(body_x_1)'"),
                               ("contact between bodies", "material points"), ()),
}
# The same is left out or kept in other models, which cost less.
ONLY_AT_FULL_LENGTH = {"a light block in water is not", "a membrane in thin air", "a pendulum of points, by elements"}


def is_left_out(part, said):
    """Runs with little viscosity and with none take about the same, and what costs more without it is kept."""
    return (f"left out: {part}" in said or
            part == VISCOSITY and re.search(f"kept: {part}, .*: the run costs more without it", said) is not None)


class AutoModels(unittest.TestCase):
    def test_what_is_left_out(self):
        models = {name: model for name, model in MODELS.items() if FULL or name not in ONLY_AT_FULL_LENGTH}
        for name, (deck, tolerance, values, left_out, kept) in models.items():
            with self.subTest(name), tempfile.TemporaryDirectory() as folder:
                done = run(deck, "--auto", tolerance, "--out", pathlib.Path(folder) / "out",
                           *[word for value in (f"auto.budget={5 * SLOWER}", *values) for word in ("--set", value)])
                self.assertIn(done.returncode, (0, 5), done.stdout + done.stderr)
                for part in left_out:
                    self.assertTrue(is_left_out(part, done.stdout), f"{part}\n{done.stdout}")
                for part in kept:
                    self.assertIn(f"kept: {part}", done.stdout)

    def test_elements_in_place_of_points_are_refined(self):
        """Their levels differ in the mesh, which the runs by points leave alone."""
        with tempfile.TemporaryDirectory() as folder:
            done = run("tests/auto/decks/pendulum.in", "--auto", 0.02, "--dry-run", "--out", pathlib.Path(folder) / "out")
            lines = done.stdout.splitlines()
            by_elements = [line for line in lines if "in.path='fem'" in line]
            self.assertEqual(len(by_elements), 1, done.stdout)
            self.assertIn("mesh.cells(1,1)=2 ", by_elements[0])
            self.assertNotIn("in.nx", by_elements[0])
            self.assertNotIn("mesh.cells", " ".join(line for line in lines if line not in by_elements))

    def test_a_plan_says_what_is_left_out_and_by_which_number(self):
        with tempfile.TemporaryDirectory() as folder:
            deck, tolerance, values, _, _ = MODELS["thin gas"]
            done = run("plan", "--auto", tolerance, deck, "--out", pathlib.Path(folder) / "out",
                       *[word for value in values for word in ("--set", value)])
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertTrue(is_left_out(VISCOSITY, done.stdout), done.stdout)
            self.assertRegex(done.stdout, rf": {VISCOSITY}, which changes the number by \S+ %")


if __name__ == "__main__":
    unittest.main()
