# SPDX-License-Identifier: GPL-3.0-or-later
"""NetCDF files by the CF conventions, as xarray reads them: axes, bounds, times as numbers, integers as integers."""
import unittest

import netCDF4
import numpy
import xarray

from program import DECKS, ProgramTest, sets


def axes_of(data):
    return {name: data[name].attrs.get("axis") for name in data.coords if "axis" in data[name].attrs}


class Conventions(ProgramTest):
    def assert_times_are_numbers(self, data):
        self.assertEqual(data["time"].dtype, float)
        self.assertEqual(data["time"].attrs["axis"], "T")

    def test_a_box_is_a_grid_of_cells_with_bounds(self):
        out = self.run_ok(DECKS / "coupled-bar.in", *sets(in__tmax=0.05, in__units="'si'"))
        with xarray.open_dataset(out / "mesh.nc") as data:
            self.assert_times_are_numbers(data)
            self.assertEqual(data["time"].attrs["standard_name"], "time")
            self.assertEqual(data["p"].dims, ("time", "y", "x"))
            self.assertEqual(axes_of(data), {"time": "T", "y": "Y", "x": "X"})
            for axis in "xy":
                bounds = data[data[axis].attrs["bounds"]]
                self.assertEqual(data[axis].attrs["units"], "m")
                numpy.testing.assert_allclose(bounds.mean(axis=1), data[axis], rtol=0, atol=1e-14)
                numpy.testing.assert_allclose(bounds[1:, 0], bounds[:-1, 1], rtol=0, atol=1e-14)
            self.assertEqual(data["kind"].dtype.kind, "i")
            self.assertEqual(data["region"].dtype.kind, "i")

    def test_points_have_whole_numbers_and_a_grid_of_nodes(self):
        out = self.run_ok(DECKS / "sod.in", *sets(in__tmax=0.01))
        with xarray.open_dataset(out / "particles.nc") as data:
            self.assert_times_are_numbers(data)
            for name in ("id", "body"):
                self.assertEqual(data[name].dtype.kind, "i", name)
        with xarray.open_dataset(out / "mesh.nc") as data:
            self.assertEqual(axes_of(data), {"time": "T", "node_y": "Y", "node_x": "X"})
        with xarray.open_dataset(out / "history.nc") as data:
            self.assert_times_are_numbers(data)

    def test_faces_of_nine_nodes_are_four_cornered(self):
        out = self.run_ok(DECKS / "cylinder.in")
        with netCDF4.Dataset(out / "mesh.nc") as data:
            corners = data[data["mesh"].face_node_connectivity]
            self.assertEqual(corners.shape, (data.dimensions["element"].size, 4))
            self.assertEqual(corners.cf_role, "face_node_connectivity")
            x, y = (data[f"node_{axis}"][:][corners[:]] for axis in "xy")
            area = sum(x[:, k] * y[:, (k + 1) % 4] - x[:, (k + 1) % 4] * y[:, k] for k in range(4)) / 2
            self.assertGreater(area.min(), 0)  # the corners go round


if __name__ == "__main__":
    unittest.main()
