# SPDX-License-Identifier: GPL-3.0-or-later
"""post/vtu.py on meshes written here: the files it makes, read back number by number; and on a run of the program."""
import base64
import os
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as xml
from pathlib import Path

import netCDF4
import numpy

ROOT = Path(__file__).resolve().parents[2]
TYPES = {"Float64": "<f8", "Int64": "<i8", "UInt8": "u1"}


def write_mesh(folder, dimension, elements, places, times, elements_there=True):
    """A mesh.nc as the program writes it; node n moves by (n, 2 n, 3 n) a time and has the energy density n + t."""
    nodes = len(places)
    with netCDF4.Dataset(folder / "mesh.nc", "w") as data:
        data.createDimension("time", None)
        data.createDimension("node", nodes)
        data.createVariable("time", "f8", ("time",))[:] = times
        numbers = numpy.arange(nodes)
        fields = {"energy_density": numpy.add.outer(times, numbers)}
        for k, axis in enumerate("xyz"[:dimension]):
            moved = numpy.outer(times, (k + 1) * numbers)
            fields[axis] = places[:, k] + moved
            fields["u" + axis] = moved
        for name, values in fields.items():
            data.createVariable(name, "f8", ("time", "node"))[:] = values
        if not elements_there:
            return
        mesh = data.createVariable("mesh", "i4")
        mesh.topology_dimension = numpy.int32(dimension)
        data.createDimension("element", len(elements))
        data.createDimension("node_of_element", len(elements[0]))
        data.createVariable("element_nodes", "i4", ("element", "node_of_element"))[:] = elements
        data.createVariable("element_region", "i4", ("element",))[:] = numpy.arange(len(elements))


def arrays(path):
    """{section: {name: array}} of a .vtu, and its Piece's counts."""
    root = xml.parse(path).getroot()
    assert root.attrib["header_type"] == "UInt64" and root.attrib["byte_order"] == "LittleEndian"
    piece = root.find("UnstructuredGrid/Piece")
    found = {}
    for section in piece:
        for array in section:
            raw = base64.b64decode(array.text.strip(), validate=True)
            length = int(numpy.frombuffer(raw[:8], "<u8")[0])
            assert length == len(raw) - 8, (length, len(raw))
            values = numpy.frombuffer(raw[8:], TYPES[array.attrib["type"]])
            if "NumberOfComponents" in array.attrib:
                values = values.reshape(-1, int(array.attrib["NumberOfComponents"]))
            found.setdefault(section.tag, {})[array.attrib["Name"]] = values
    return found, int(piece.attrib["NumberOfPoints"]), int(piece.attrib["NumberOfCells"])


def vtu(*words):
    return subprocess.run([sys.executable, ROOT / "post" / "vtu.py", *words], capture_output=True, text=True)


class VtuTest(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)

    def test_a_plane_mesh_number_by_number(self):
        places = numpy.array([[0.1, 0], [1, 0], [2, 0], [0, 1], [1, 1], [2, 1 / 3]])
        elements, times = [[0, 1, 4, 3], [1, 2, 5, 4]], numpy.array([0, 0.1])
        write_mesh(self.folder, 2, elements, places, times)
        result = vtu(self.folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        names = ["mesh-0000.vtu", "mesh-0001.vtu", "mesh.pvd"]
        self.assertEqual(result.stdout.split(), [str(self.folder / name) for name in names])
        for record, time in enumerate(times):
            found, points, cells = arrays(self.folder / names[record])
            self.assertEqual((points, cells), (6, 2))
            numbers = numpy.arange(6)
            moved = numpy.column_stack([time * numbers, 2 * time * numbers, 0 * numbers])
            at = numpy.column_stack([places, numpy.zeros(6)]) + moved
            numpy.testing.assert_array_equal(found["Points"]["points"], at)
            numpy.testing.assert_array_equal(found["PointData"]["displacement"], moved)
            numpy.testing.assert_array_equal(found["PointData"]["energy_density"], numbers + time)
            self.assertEqual(set(found["PointData"]), {"displacement", "energy_density"})
            numpy.testing.assert_array_equal(found["CellData"]["region"], [0, 1])
            numpy.testing.assert_array_equal(found["Cells"]["connectivity"], numpy.ravel(elements))
            numpy.testing.assert_array_equal(found["Cells"]["offsets"], [4, 8])
            numpy.testing.assert_array_equal(found["Cells"]["types"], [9, 9])

    def test_bodies_in_a_fluid_have_files_of_their_own(self):
        """They were left out without a word."""
        write_mesh(self.folder, 2, [[0, 1, 2]], numpy.eye(3)[:, :2], numpy.array([0.0, 0.5]))
        (self.folder / "mesh.nc").rename(self.folder / "solids.nc")
        write_mesh(self.folder, 2, [[0, 1, 3, 2]], numpy.array([[0, 0], [2, 0], [0, 2], [2, 2]]), numpy.array([0.0, 0.5]))
        result = vtu(self.folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        names = [f"{name}-000{k}.vtu" for name in ("mesh", "solids") for k in (0, 1)]
        names[2:2], names[5:] = ["mesh.pvd"], ["solids.pvd"]
        self.assertEqual(result.stdout.split(), [str(self.folder / name) for name in names])
        self.assertEqual([arrays(self.folder / name)[1] for name in (names[1], names[4])], [4, 3])
        self.assertIn("solids-0001.vtu", (self.folder / "solids.pvd").read_text())

    def test_names_the_files_with_their_times(self):
        write_mesh(self.folder, 2, [[0, 1, 2]], numpy.eye(3)[:, :2], numpy.array([0, 1 / 3, 1e-9]))
        self.assertEqual(vtu(self.folder, "--out", self.folder / "deep" / "vtk").returncode, 0)
        root = xml.parse(self.folder / "deep" / "vtk" / "mesh.pvd").getroot()
        told = [(float(d.attrib["timestep"]), d.attrib["file"]) for d in root.iter("DataSet")]
        self.assertEqual(told, [(0, "mesh-0000.vtu"), (1 / 3, "mesh-0001.vtu"), (1e-9, "mesh-0002.vtu")])
        for _, name in told:
            self.assertTrue((self.folder / "deep" / "vtk" / name).is_file())

    def test_each_kind_of_element_has_its_cell(self):
        for dimension, nodes, cell in [(2, 3, 5), (2, 4, 9), (2, 9, 28), (3, 4, 10), (3, 8, 12), (3, 27, 29)]:
            with self.subTest(cell=cell):
                write_mesh(self.folder, dimension, [list(range(nodes))], numpy.random.rand(nodes, dimension),
                           numpy.array([0.0]))
                self.assertEqual(vtu(self.folder).returncode, 0)
                found, points, _ = arrays(self.folder / "mesh-0000.vtu")
                self.assertEqual(points, nodes)
                numpy.testing.assert_array_equal(found["Cells"]["types"], [cell])

    def test_a_run_of_the_program(self):
        result = subprocess.run([os.environ["TETHER"], ROOT / "decks" / "cook.in", "--quiet", "--out", self.folder,
                                 "--set", "mesh.cells(1,1)=2,3"], capture_output=True, text=True)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(vtu(self.folder).returncode, 0)
        found, points, cells = arrays(self.folder / "mesh-0001.vtu")
        self.assertEqual((points, cells), (5 * 7, 6))
        with netCDF4.Dataset(self.folder / "mesh.nc") as data:
            self.assertEqual(data.Conventions, "CF-1.10 UGRID-1.0")
            self.assertEqual(data["mesh"].topology_dimension, 2)
            for k, axis in enumerate("xy"):
                numpy.testing.assert_array_equal(found["Points"]["points"][:, k], data[axis][1])
                numpy.testing.assert_array_equal(data["node_" + axis][:], data[axis][0])
            numpy.testing.assert_array_equal(found["PointData"]["sxx"], data["sxx"][1])
        # The corners of the first cell go round it: the area they enclose is positive.
        x, y, _ = found["Points"]["points"][found["Cells"]["connectivity"][:4]].T
        self.assertGreater(sum(x * numpy.roll(y, -1) - y * numpy.roll(x, -1)), 0)

    def check_refused(self, code, *needles):
        result = vtu(self.folder)
        self.assertEqual(result.returncode, code, result.stderr)
        for needle in needles:
            self.assertIn(needle, result.stderr)
        self.assertNotIn("Traceback", result.stderr)
        self.assertEqual(list(self.folder.glob("*.vtu")), [])

    def test_refuses_what_is_no_mesh_of_elements(self):
        self.check_refused(2, "mesh.nc", "iout(39)=1")
        write_mesh(self.folder, 2, [], numpy.eye(3)[:, :2], numpy.array([0.0]), elements_there=False)
        self.check_refused(2, "no mesh of finite elements")
        (self.folder / "mesh.nc").write_text("x,y\n0,1\n")
        self.check_refused(2, "cannot be read as NetCDF")
        write_mesh(self.folder, 2, [[0, 1, 2]], numpy.eye(3)[:, :2], numpy.array([]))
        self.check_refused(2, "no records")

    def test_tells_that_it_cannot_write(self):
        write_mesh(self.folder, 2, [[0, 1, 2]], numpy.eye(3)[:, :2], numpy.array([0.0]))
        (self.folder / "taken").write_text("")
        result = vtu(self.folder, "--out", self.folder / "taken")
        self.assertEqual(result.returncode, 4)
        self.assertIn("taken", result.stderr)


if __name__ == "__main__":
    unittest.main()
