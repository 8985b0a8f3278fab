#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh of CalculiX or Abaqus as a mesh file for tether: python3 post/inp.py FILE.inp [--out FILE.msh].

Element sets become physical groups that a deck's physical(r) names. Where sets overlap an element is of the smallest one, of
equal ones of that which its *ELEMENT line names; sets that are left without elements are reported. A node set that has the nodes
of whole outer sides and no others becomes a physical group of these sides, any other a group of points, which a deck's loads and
supports may name. meshio (Debian's python3-meshio) reads the file.
Exit codes: 0 done, 2 the file cannot be understood, 4 the mesh file could not be written.
"""
import argparse
import re
import sys
from pathlib import Path

import numpy

import command
from scene import topology

# meshio's name of a cell: its dimension, Gmsh's number of it, and its sides by its nodes with Gmsh's number of those.
# Gmsh counts the last two middles of a tetrahedron the other way round.
CELLS = {
    "triangle": (2, 2, topology.EDGES[3], 1),
    "quad": (2, 3, topology.EDGES[4], 1),
    "tetra": (3, 4, topology.TETRAHEDRON, 2),
    "triangle6": (2, 9, ((0, 1, 3), (1, 2, 4), (2, 0, 5)), 8),
    "tetra10": (3, 11, topology.TETRAHEDRON_10, 9),
    "hexahedron": (3, 5, topology.HEXAHEDRON, 3),
}
POINT = 15
GMSH_ORDER = {"tetra10": (0, 1, 2, 3, 4, 5, 6, 7, 9, 8)}


def arguments(words):
    parser = argparse.ArgumentParser(description="Makes a .msh of Gmsh's format 2.2 of an .inp of CalculiX or Abaqus.")
    parser.add_argument("file", type=Path, metavar="FILE.inp")
    parser.add_argument("--out", type=Path, metavar="FILE.msh", help="the mesh file (default: FILE.msh)")
    return parser.parse_args(words)


def read(path):
    """The mesh as meshio has it."""
    try:
        import meshio
    except ImportError as reason:
        raise command.Refused("meshio is not installed: apt install python3-meshio") from reason
    if not path.is_file():
        raise command.Refused(f"{path}: there is no such file")
    try:
        return meshio.read(path, file_format="abaqus")
    except (SystemExit, Exception) as reason:  # meshio ends the process where it cannot read a file
        raise command.Refused(f"{path}: meshio cannot read it: {reason}") from reason


def bodies_of(mesh):
    """The blocks of cells of the highest dimension that are known, with their places among all blocks."""
    known = [(k, block) for k, block in enumerate(mesh.cells) if block.type in CELLS]
    if not known:
        names = sorted({block.type for block in mesh.cells})
        raise command.Refused(f"there are no 3-, 4- or 6-node elements in the plane, or 4-, 8- or 10-node ones in space, but {names}")
    dimension = max(CELLS[block.type][0] for _, block in known)
    return dimension, [(k, block) for k, block in known if CELLS[block.type][0] == dimension]


def first_sets(path):
    """The element sets that *ELEMENT lines name."""
    lines = [line for line in path.read_text().splitlines() if line.upper().startswith("*ELEMENT")]
    return {name for line in lines for name in re.findall(r"(?i)\bELSET\s*=\s*([^,\s]+)", line)}


def regions_of(mesh, bodies, first):
    """The names of the sets, and of each cell the number of its set, block by block."""
    def rank(cell_set):
        return sum(0 if part is None else len(part) for part in cell_set[1]), cell_set[0] not in first

    names, owners = [], [numpy.full(len(block.data), -1) for _, block in bodies]
    for name, parts in sorted(mesh.cell_sets.items(), key=rank):
        found = False
        for owner, (k, _) in zip(owners, bodies):
            cells = [] if k >= len(parts) or parts[k] is None else numpy.asarray(parts[k], dtype=int)
            free = [cell for cell in cells if owner[cell] < 0]
            owner[free] = len(names)
            found = found or len(free) > 0
        if found:
            names.append(name)
        else:
            print(f"inp: the element set {name} is left without elements: others have them")
    if any((owner < 0).any() for owner in owners):
        for owner in owners:
            owner[owner < 0] = len(names)
        names.append("rest")
    return names, owners


def outer_sides(bodies):
    """Sides that one cell has, by their nodes, with Gmsh's number."""
    seen = {}
    for _, block in bodies:
        _, _, sides, kind = CELLS[block.type]
        for cell in block.data:
            for side in sides:
                nodes = tuple(int(cell[n]) for n in side)
                seen.setdefault(frozenset(nodes), []).append((nodes, kind))
    return [found[0] for found in seen.values() if len(found) == 1]


def parts_of(mesh, bodies):
    """Of each node set its name, and the outer sides whose nodes it has, or, where these are not all of them, its nodes."""
    outer = outer_sides(bodies)
    for name, nodes in mesh.point_sets.items():
        inside = set(map(int, nodes))
        sides = [(side, kind) for side, kind in outer if inside.issuperset(side)]
        if inside == {node for side, _ in sides for node in side}:
            yield name, sides
        else:
            yield name, [((node,), POINT) for node in sorted(inside)]


def mesh_text(mesh, first):
    """The mesh file, and its groups as (dimension, name)."""
    dimension, bodies = bodies_of(mesh)
    regions, owners = regions_of(mesh, bodies, first)
    groups, elements = [(dimension, name) for name in regions], []
    for (_, block), owner in zip(bodies, owners):
        cells = block.data[:, GMSH_ORDER.get(block.type, range(block.data.shape[1]))]
        elements += [(CELLS[block.type][1], 1 + region, cell) for cell, region in zip(cells, owner)]
    for name, parts in parts_of(mesh, bodies):
        groups.append((0 if parts[0][1] == POINT else dimension - 1, name))
        elements += [(kind, len(groups), nodes) for nodes, kind in parts]
    points = numpy.zeros((len(mesh.points), 3))
    points[:, :mesh.points.shape[1]] = mesh.points
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", str(len(groups))]
    lines += [f'{dim} {tag} "{name}"' for tag, (dim, name) in enumerate(groups, 1)]
    lines += ["$EndPhysicalNames", "$Nodes", str(len(points))]
    lines += [f"{n} {x!r} {y!r} {z!r}" for n, (x, y, z) in enumerate(points.tolist(), 1)]
    lines += ["$EndNodes", "$Elements", str(len(elements))]
    lines += [f"{n} {kind} 2 {tag} {tag} " + " ".join(str(int(node) + 1) for node in nodes)
              for n, (kind, tag, nodes) in enumerate(elements, 1)]
    return "\n".join(lines + ["$EndElements", ""]), groups


def convert(chosen):
    """Writes the mesh file and yields a line with its groups."""
    out = chosen.out or chosen.file.with_suffix(".msh")
    text, groups = mesh_text(read(chosen.file), first_sets(chosen.file))
    out.write_text(text)
    words = {groups[0][0]: "region", groups[0][0] - 1: "side", 0: "nodes"}
    yield f"{out}: " + ", ".join(f"{words[dim]} '{name}'" for dim, name in groups)


def main(words=None):
    chosen = arguments(words)
    return command.run("inp", lambda: convert(chosen))


if __name__ == "__main__":
    sys.exit(main())
