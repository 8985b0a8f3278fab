# SPDX-License-Identifier: GPL-3.0-or-later
"""Decks of one step of a body in a concentric shell full of water: a cylinder in the plane, a sphere in space."""
import math

SIDE, MIDDLE = 0.8, 0.4  # of the box, which the shell stands in the middle of
MATERIAL = "1e11,.3"  # so stiff that its compression takes no part
STEP = 1e-3


def head(cells):
    return (f"a body in a shell, let go\n$in nx={cells + 1}, ny={cells + 1}, xleft=0., xright={SIDE}, ybot=0., ytop={SIDE}, "
            f"tmax={STEP}, tstep={STEP}, gravc=-9.81, iout(33)=1, tiout(33)={STEP} $\n")


def ring(inner, outer):
    """Four blocks between two squares: their second edge is the outer one's."""
    return [[inner[(k + 1) % 4], inner[k], outer[k], outer[(k + 1) % 4]] for k in range(4)]


def corners(radius):
    r = radius / math.sqrt(2)
    return [(-r, -r), (r, -r), (r, r), (-r, r)]


def arc(edge, region):
    return f",\nedge({edge},{region})='arc', edge_xc({edge},{region})={MIDDLE}, edge_yc({edge},{region})={MIDDLE}"


def cylinder_deck(folder, cells, radius, shell, density):
    """The cylinder is a square with four blocks about it, the shell four blocks that are held."""
    square = corners(radius / math.sqrt(2))
    blocks = [square, *ring(square, corners(radius)), *ring(corners(shell), corners(1.2 * shell))]
    around = 12  # elements along a quarter of the cylinder
    reg, mesh = "$reg nreg=9, nvi=9*4", "$mesh element='p1'"
    for r, block in enumerate(blocks, 1):
        for name, axis in (("xvi", 0), ("yvi", 1)):
            reg += f",\n{name}(1,{r})=" + ",".join(f"{MIDDLE + vertex[axis]:.15g}" for vertex in block)
        reg += f", densir({r})={density}, matr(1,{r})={MATERIAL}"
        mesh += f",\ncells(1,{r})={around},{around if r == 1 else 4 if r < 6 else 2}"
        mesh += arc(3, r) if r > 1 else ""
        mesh += arc(1, r) + f", side(1,{r})='shell', side(3,{r})='shell'" if r > 5 else ""
    deck = folder / f"cylinder-{cells}.in"
    deck.write_text(head(cells) + reg + " $\n" + mesh + " $\n$fem fix_on(1)='shell', fix(1:2,1)=0.,0. $\n"
                    "$coupled density=1000. $\n")
    return deck


def unit(place):
    size = math.sqrt(sum(x * x for x in place))
    return tuple(x / size for x in place)


def triangulated_sphere(halvings):
    """An octahedron, its edges halved again and again: points of radius 1, and triangles."""
    points = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    triangles = [(x, y, z) for x in (0, 1) for y in (2, 3) for z in (4, 5)]
    for _ in range(halvings):
        middles, finer = {}, []
        for triangle in triangles:
            a, b, c = triangle
            for one, other in ((a, b), (b, c), (c, a)):
                key = min(one, other), max(one, other)
                if key not in middles:
                    middles[key] = len(points)
                    points.append(unit([p + q for p, q in zip(points[one], points[other], strict=True)]))
            ab, bc, ca = (middles[min(e), max(e)] for e in ((a, b), (b, c), (c, a)))
            finer += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        triangles = finer
    return points, triangles


class Tetrahedra:
    """Nodes, tetrahedra of positive volume by group, and triangles of one group of sides."""

    def __init__(self):
        self.nodes, self.elements, self.sides = [], [], []

    def add_shell(self, points, triangles, radii, group):
        """Layers of prisms, cut into tetrahedra the same way from both sides as nodes are taken in their order."""
        first, count = len(self.nodes), len(points)
        self.nodes += [tuple(MIDDLE + r * x for x in point) for r in radii for point in points]
        for layer in range(len(radii) - 1):
            for triangle in triangles:
                a, b, c = (first + layer * count + k for k in sorted(triangle))
                for element in ((a, b, c, c + count), (a, b, b + count, c + count),
                                (a, a + count, b + count, c + count)):
                    self.add(element, group)
        return first

    def add(self, element, group):
        a, b, c, d = (self.nodes[k] for k in element)
        u, v, w = ([q - p for p, q in zip(a, x, strict=True)] for x in (b, c, d))
        volume = sum(u[i] * (v[i - 2] * w[i - 1] - v[i - 1] * w[i - 2]) for i in range(3))
        self.elements.append((element if volume > 0 else (*element[:2], element[3], element[2]), group))

    def write(self, path):
        rows = [f"{k} 4 2 {group} {group} " + " ".join(str(n + 1) for n in element)
                for k, (element, group) in enumerate(self.elements, 1)]
        rows += [f"{k} 2 2 3 3 " + " ".join(str(n + 1) for n in side)
                 for k, side in enumerate(self.sides, len(rows) + 1)]
        nodes = [f"{k} " + " ".join(f"{x:.16g}" for x in node) for k, node in enumerate(self.nodes, 1)]
        path.write_text("\n".join(["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", "3", '2 3 "shell"',
                                   '3 1 "ball"', '3 2 "around"', "$EndPhysicalNames", "$Nodes", str(len(nodes)), *nodes,
                                   "$EndNodes", "$Elements", str(len(rows)), *rows, "$EndElements", ""]))


def sphere_deck(folder, cells, radius, shell, density):
    """The sphere is region 1, and the shell, which is held, region 2 of a mesh file."""
    points, triangles = triangulated_sphere(3)
    mesh = Tetrahedra()
    mesh.add_shell(points, triangles, (radius / 2, radius), 1)
    mesh.nodes.append((MIDDLE,) * 3)
    for triangle in triangles:
        mesh.add((len(mesh.nodes) - 1, *triangle), 1)
    first = mesh.add_shell(points, triangles, (shell, 1.2 * shell), 2)
    mesh.sides = [tuple(first + layer * len(points) + k for k in triangle) for layer in (0, 1) for triangle in triangles]
    mesh.write(folder / "ball.msh")
    deck = folder / f"sphere-{cells}.in"
    deck.write_text(head(cells) + f"$reg nreg=2, densir(1)=2*{density}, matr(1,1)={MATERIAL}, matr(1,2)={MATERIAL} $\n"
                    "$mesh element='p1', file='ball.msh' $\n$fem fix_on(1)='shell', fix(1:3,1)=0.,0.,0. $\n"
                    f"$coupled density=1000., nz={cells + 1}, zback=0., zfront={SIDE} $\n")
    return deck
