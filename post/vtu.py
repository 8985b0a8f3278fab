#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A run's mesh.nc as VTK files, for programs that read no XDMF: python3 post/vtu.py DIR [--out FOLDER].

Writes mesh-0000.vtu and so on, one a snapshot, and mesh.pvd, which names them with their times; of bodies in a fluid, which
are in solids.nc, solids-0000.vtu and so on and solids.pvd.
Exit codes: 0 done, 2 DIR has no mesh of finite elements, 4 a file could not be written.
"""
import argparse
import base64
import sys
from pathlib import Path
from xml.sax.saxutils import quoteattr

import numpy

import run_folder

# VTK's number of a cell by dimension and nodes; mesh.nc counts the nodes of an element as VTK does.
CELLS = {(2, 3): 5, (2, 4): 9, (2, 9): 28, (3, 4): 10, (3, 8): 12, (3, 27): 29}

# Fields that are the components of a vector.
VECTORS = {"displacement": ("ux", "uy", "uz"), "velocity": ("vx", "vy", "vz")}

TYPES = {"f": "Float64", "i": "Int64", "u": "UInt8"}


def arguments(words):
    parser = argparse.ArgumentParser(description="Writes a run's mesh and its fields as .vtu files and a .pvd.")
    parser.add_argument("folder", type=Path, metavar="DIR", help="folder of the run, with its mesh.nc")
    parser.add_argument("--out", type=Path, metavar="FOLDER", help="folder for the files (default: DIR)")
    return parser.parse_args(words)


class Mesh:
    """What mesh.nc holds: elements, their regions, times, and fields over (time, node)."""

    def __init__(self, path):
        if not path.is_file():
            raise run_folder.NotARun(f"{path}: is not there: iout(39)=1 has a run write it")
        with run_folder.open_dataset(path) as data:
            if "element_nodes" not in data.variables:
                raise run_folder.NotARun(f"{path}: is no mesh of finite elements; mesh.xmf opens it in ParaView")
            self.elements = numpy.asarray(data["element_nodes"][:], dtype=numpy.int64)
            self.region = numpy.asarray(data["element_region"][:], dtype=numpy.int64)
            self.times = numpy.asarray(data["time"][:], dtype=float)
            self.dimension = int(data["mesh"].topology_dimension)
            names = [name for name, variable in data.variables.items() if variable.dimensions == ("time", "node")]
            self.fields = {name: numpy.asarray(data[name][:], dtype=float) for name in names}
        kind = (self.dimension, self.elements.shape[1])
        if kind not in CELLS or len(self.times) == 0:
            raise run_folder.NotARun(f"{path}: holds no records of elements that are known")
        self.cell = CELLS[kind]

    def vector(self, names, record):
        """Components as columns, 0 where the mesh has no such direction."""
        nodes = next(iter(self.fields.values())).shape[1]
        columns = [self.fields[name][record] if name in self.fields else numpy.zeros(nodes) for name in names]
        return numpy.column_stack(columns)

    def node_data(self, record):
        """Arrays by name: vectors, then what is part of none."""
        found = {name: self.vector(parts, record) for name, parts in VECTORS.items() if parts[0] in self.fields}
        used = {"x", "y", "z"}.union(*VECTORS.values())
        found.update({name: values[record] for name, values in self.fields.items() if name not in used})
        return found


def data_array(name, values):
    """A DataArray: the number of bytes, then the bytes, little-endian, in base64."""
    kind = values.dtype.kind
    raw = numpy.ascontiguousarray(values).astype(values.dtype.newbyteorder("<")).tobytes()
    text = base64.b64encode(numpy.array([len(raw)], dtype="<u8").tobytes() + raw).decode()
    components = f' NumberOfComponents="{values.shape[1]}"' if values.ndim == 2 else ""
    return f'<DataArray type="{TYPES[kind]}" Name={quoteattr(name)}{components} format="binary">{text}</DataArray>\n'


def vtu_text(mesh, record):
    count, per_element = mesh.elements.shape
    parts = {
        "PointData": mesh.node_data(record),
        "CellData": {"region": mesh.region},
        "Points": {"points": mesh.vector(("x", "y", "z"), record)},
        "Cells": {"connectivity": mesh.elements.ravel(),
                  "offsets": per_element * numpy.arange(1, count + 1, dtype=numpy.int64),
                  "types": numpy.full(count, mesh.cell, dtype=numpy.uint8)},
    }
    nodes = len(parts["Points"]["points"])
    text = ('<?xml version="1.0"?>\n<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" '
            f'header_type="UInt64">\n<UnstructuredGrid>\n<Piece NumberOfPoints="{nodes}" NumberOfCells="{count}">\n')
    for part, arrays in parts.items():
        text += f"<{part}>\n" + "".join(data_array(name, values) for name, values in arrays.items()) + f"</{part}>\n"
    return text + "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n"


def pvd_text(times, names):
    text = ('<?xml version="1.0"?>\n<VTKFile type="Collection" version="0.1" byte_order="LittleEndian">\n'
            "<Collection>\n")
    for time, name in zip(times, names):
        text += f'<DataSet timestep="{float(time)!r}" part="0" file={quoteattr(name)}/>\n'
    return text + "</Collection>\n</VTKFile>\n"


def write_all(mesh, name, folder):
    """Writes the files, whose names begin with this one, and yields their paths."""
    folder.mkdir(parents=True, exist_ok=True)
    names = [f"{name}-{record:04d}.vtu" for record in range(len(mesh.times))]
    for record, file in enumerate(names):
        (folder / file).write_text(vtu_text(mesh, record))
        yield folder / file
    (folder / f"{name}.pvd").write_text(pvd_text(mesh.times, names))
    yield folder / f"{name}.pvd"


def main(words=None):
    chosen = arguments(words)
    try:
        meshes = {"mesh": Mesh(chosen.folder / "mesh.nc")}
        if (chosen.folder / "solids.nc").is_file():
            meshes["solids"] = Mesh(chosen.folder / "solids.nc")
    except run_folder.NotARun as mistake:
        print(f"vtu: {mistake}", file=sys.stderr)
        return 2
    try:
        for name, mesh in meshes.items():
            for path in write_all(mesh, name, chosen.out or chosen.folder):
                print(path)
    except OSError as reason:
        print(f"vtu: {reason}", file=sys.stderr)
        return 4
    return 0


if __name__ == "__main__":
    sys.exit(main())
