# SPDX-License-Identifier: GPL-3.0-or-later
"""Run by pvpython: opens each file given with ParaView's default reader for it and prints what it finds, as JSON.

For each file: the reader's name, the times, and of the last time the points, and the arrays of points and of cells.
"""
import json
import sys

from paraview import servermanager, simple
from vtk.util.numpy_support import vtk_to_numpy


def arrays(data):
    found = [data.GetArray(k) for k in range(data.GetNumberOfArrays())]
    return {array.GetName(): vtk_to_numpy(array).tolist() for array in found}


def read(path):
    reader = simple.OpenDataFile(path)
    times = reader.TimestepValues
    times = list(times) if hasattr(times, "__len__") else [times]
    reader.UpdatePipeline(times[-1])
    data = servermanager.Fetch(reader)
    points = [data.GetPoint(k) for k in range(data.GetNumberOfPoints())]
    cells = [[data.GetCell(k).GetPointId(n) for n in range(data.GetCell(k).GetNumberOfPoints())]
             for k in range(min(data.GetNumberOfCells(), 50))]
    return {"reader": type(reader).__name__, "times": times, "points": points, "cells": cells,
            "of_points": arrays(data.GetPointData()), "of_cells": arrays(data.GetCellData())}


print(json.dumps({path: read(path) for path in sys.argv[1:]}))
