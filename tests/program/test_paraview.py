# SPDX-License-Identifier: GPL-3.0-or-later
"""ParaView's default readers open every series of VTK files, and read back what the NetCDF files have."""
import json
import subprocess
import unittest

import netCDF4
import numpy

from program import DECKS, ProgramTest

FIELDS = ("--set", "in.iout(39)=1", "--set", "in.tiout(39)=.01")


def by_paraview(paths):
    words = ["pvpython", "--force-offscreen-rendering", "tests/program/read_by_paraview.py", *map(str, paths)]
    done = subprocess.run(words, capture_output=True, text=True, check=True)
    return json.loads(done.stdout[done.stdout.index("{"):])


# Deck, options and series of each run.
RUNS = {"points": ("gas-expansion", ("--set", "in.iout(13)=1", "--set", "in.tiout(13)=.01", *FIELDS), ("particles", "mesh")),
        "elements": ("cylinder", (), ("mesh",)),
        "box": ("coupled-paddle-3d", ("--set", "in.tmax=.1"), ("mesh", "solids"))}


class ParaView(ProgramTest):
    @classmethod
    def setUpClass(cls):
        """All runs, and what ParaView, which takes seconds to start, reads of them."""
        super().setUpClass()
        case = ProgramTest.shared_by(cls)
        cls.out = {name: case.run_ok(DECKS / f"{deck}.in", *words, out=name) for name, (deck, words, _) in RUNS.items()}
        cls.found = by_paraview([cls.out[name] / f"{series}.pvd" for name, run in RUNS.items() for series in run[2]])

    def compare(self, folder, name, vectors, numbers, where="of_points"):
        """The last record of NAME.nc, and what ParaView reads of NAME.pvd."""
        found = self.found[str(folder / f"{name}.pvd")]
        self.assertEqual(found["reader"], "PVDReader")
        with netCDF4.Dataset(folder / f"{name}.nc") as data:
            self.assertEqual(found["times"], data["time"][:].tolist())
            for vector, parts in vectors.items():
                read = numpy.array(found["points"] if vector == "points" else found[where][vector])
                for part, column in zip(parts, read.T):
                    self.assertEqual(column.tolist(), data[part][-1].ravel().tolist(), part)
            for number in numbers:
                self.assertEqual(found[where][number], data[number][-1].ravel().tolist(), number)
        return found

    def test_points_and_the_nodes_of_their_grid(self):
        out = self.out["points"]
        points = self.compare(out, "particles", {"points": ("x", "y"), "v": ("vx", "vy")}, ("pressure", "sxx", "id"))
        self.assertEqual(points["cells"][7], [7])
        grid = self.compare(out, "mesh", {"v": ("vx", "vy"), "force": ("force_x", "force_y")}, ("mass", "pressure"))
        with netCDF4.Dataset(out / "mesh.nc") as data:
            places = [[x, y, 0.0] for y in data["node_y"][:] for x in data["node_x"][:]]
        self.assertLess(numpy.abs(numpy.array(grid["points"]) - places).max(), 1e-12)

    def test_elements_of_nine_nodes(self):
        out = self.out["elements"]
        mesh = self.compare(out, "mesh", {"points": ("x", "y"), "v": ("vx", "vy")}, ("p", "stream"))
        with netCDF4.Dataset(out / "mesh.nc") as data:
            self.assertEqual(mesh["cells"], data["element_nodes"][:50].tolist())
            self.assertEqual(mesh["of_cells"]["region"], data["element_region"][:].tolist())

    def test_a_box_in_space_and_the_bodies_in_it(self):
        out = self.out["box"]
        box = self.compare(out, "mesh", {"v": ("vx", "vy", "vz")}, ("p", "kind"), "of_cells")
        with netCDF4.Dataset(out / "mesh.nc") as data:
            low = [data[f"{axis}_bounds"][0, 0] for axis in "xyz"]
            high = [data[f"{axis}_bounds"][-1, 1] for axis in "xyz"]
            self.assertEqual(data["p"].dimensions, ("time", "z", "y", "x"))
        self.assertLess(numpy.abs(numpy.min(box["points"], axis=0) - low).max(), 1e-12)
        self.assertLess(numpy.abs(numpy.max(box["points"], axis=0) - high).max(), 1e-12)
        self.compare(out, "solids", {"points": ("x", "y", "z"), "u": ("ux", "uy", "uz")}, ("sxx", "sxz"))

    def test_is_left_out_where_the_deck_says_so(self):
        out = self.run_ok(DECKS / "plate-hole.in", "--set", "in.vtk='no'")
        self.assertTrue((out / "mesh.nc").is_file())
        self.assertFalse((out / "mesh.pvd").exists() or (out / "vtk").exists())


if __name__ == "__main__":
    unittest.main()
