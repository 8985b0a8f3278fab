# SPDX-License-Identifier: GPL-3.0-or-later
"""Material points: gas, fluids and solids, each coloured by the quantity that matters for it, membranes as lines."""
from dataclasses import dataclass, field

import numpy
from matplotlib import collections, lines

import style
from scene import quantities

SPREAD = 1.0  # per cent of the points at either end that a scale leaves out: they scatter
GAS, FLUID = (7, 9), (8,)  # laws of ipath(4,r)
HEAVY = 20.0  # times the mass of a body's other points: drawn as a mass of its own
SMALLEST, LARGEST = 0.3, 2.5  # a point's width over the usual one, beyond which it is drawn no smaller and no larger
LEAST_MARK = 0.8  # width of a mark in the figure's points
GAP = 6.0  # times the usual distance of neighbours: a membrane's line ends there
QUANTITY = {"gas": "pressure", "solid": "von Mises stress"}


@dataclass
class Kind:
    """The bodies that are drawn alike."""

    name: str
    bodies: list = field(default_factory=list)
    scale: quantities.Scale = None


def kind_of_body(run, name, values, chosen):
    """gas, fluid, solid or membrane, by the deck's law for a region and by normals, which membranes have alone."""
    if "normal_x" in values and (abs(values["normal_x"][chosen]) + abs(values["normal_y"][chosen]) > 0.5).all():
        return "membrane"
    law = run.deck_values.get(f"reg.ipath(4,{name.removeprefix('region ')})") if name.startswith("region ") else None
    return "gas" if law in GAS else "fluid" if law in FLUID else "solid"


def grid_limits(run):
    """The background grid's: a whole domain of points; None where the deck does not say."""
    found = [run.deck_values.get(f"in.{name}") for name in ("xleft", "xright", "ybot", "ytop")]
    return tuple(found) if all(isinstance(value, float) for value in found) else None


def short_names(names):
    """Up to three names, or the first and the last of more."""
    return ", ".join(names) if len(names) <= 3 else f"{names[0]} to {names[-1]}"


def pieces(places):
    """A membrane's points in their order, parted where neighbours are far apart."""
    distances = numpy.hypot(*numpy.diff(places, axis=0).T)
    distances = numpy.where(numpy.isfinite(distances), distances, 0.0)
    usual = numpy.median(distances) if len(distances) else 0.0
    return numpy.split(places, 1 + numpy.flatnonzero(distances > GAP * usual))


def fluids_quantity(run):
    """Of a linear fluid: its pressure where it has weight, else its speed: in a box the level of pressure says nothing."""
    return "p" if run.deck_values.get("in.gravc") else "speed"


class Points:
    """A layer of particles.nc."""

    axes_names = ("x", "y")

    def __init__(self, run, name=None):
        self.run, self.fields = run, run.fields("particles")
        self.times = self.fields.times
        self.kinds = self._kinds(name)
        self.scales = [kind.scale for kind in self.kinds.values() if kind.scale]
        self.about_axis = bool(run.deck_values.get("in.cyl"))

    def _kinds(self, name):
        values, found = self.fields.at(0), {}
        bodies = values.get("body", numpy.ones(len(values["x"])))
        for body in numpy.unique(bodies[numpy.isfinite(bodies)]).astype(int):
            named = self.run.body_names[body - 1] if body <= len(self.run.body_names) else f"body {body}"
            kind = kind_of_body(self.run, named, values, bodies == body)
            found.setdefault(kind, Kind(kind)).bodies.append((body, named))
        for kind in found.values():
            if kind.name != "membrane":
                kind.scale = self._scale(name or QUANTITY.get(kind.name) or fluids_quantity(self.run))
        return found

    def _scale(self, name):
        field = "pressure" if name == "p" else name
        if not quantities.has(self.fields, field):
            return None
        return quantities.Scale(name, quantities.unit(self.fields, field))

    def values(self, kind, record):
        """The places and the quantity of a kind's points."""
        values = self.fields.at(record)
        chosen = numpy.isin(values.get("body", numpy.ones(len(values["x"]))), [body for body, _ in kind.bodies])
        name = "pressure" if kind.scale and kind.scale.name == "p" else kind.scale.name if kind.scale else None
        return {"places": numpy.column_stack([values["x"], values["y"]])[chosen], "mass": values["mass"][chosen],
                "side": self.sides(values)[chosen],
                "value": quantities.value_of(values, name)[chosen] if name else None,
                "body": values.get("body", numpy.ones(len(chosen)))[chosen]}

    def limits(self, records):
        own = quantities.largest(quantities.limits_of(self.fields.places(record)) for record in records)
        grid = grid_limits(self.run)
        return quantities.largest([own, grid]) if grid else own

    def fit(self, records):
        for scale in self.scales:
            kinds = [kind for kind in self.kinds.values() if kind.scale is scale]
            scale.fit([self.values(kind, record)["value"] for kind in kinds for record in records], SPREAD)

    def sides(self, values):
        """How wide each point is, by its volume; about an axis that is one of a ring."""
        if "volume" not in values:
            return numpy.full(len(values["x"]), numpy.nan)
        areas = values["volume"] / numpy.maximum(abs(values["x"]), 1e-300) if self.about_axis else values["volume"]
        sides = numpy.sqrt(numpy.maximum(areas, 0))
        usual = numpy.nanmedian(sides) if numpy.isfinite(sides).any() else 0.0
        return numpy.clip(sides, SMALLEST * usual, LARGEST * usual)

    @staticmethod
    def marks(axes, sides):
        """Widths and heights of points, so that a body is a whole; none is too small to be seen."""
        extent, (left, right), (low, high) = axes.get_window_extent(), axes.get_xlim(), axes.get_ylim()
        least = LEAST_MARK * axes.figure.dpi / 72 * numpy.array(((right - left) / extent.width, (high - low) / extent.height))
        return numpy.maximum(numpy.nan_to_num(sides, nan=(right - left) / 100), least[:, None])

    def draw(self, axes, record):
        for kind in self.kinds.values():
            found = self.values(kind, record)
            if kind.name == "membrane":
                self.draw_membranes(axes, kind, found)
            else:
                self.draw_bodies(axes, kind, found)

    def draw_bodies(self, axes, kind, found):
        across, up = self.marks(axes, found["side"])
        half = 0.5 * numpy.stack([across, up], axis=-1)[:, None]
        corners = found["places"][:, None] + half * numpy.array(((-1, -1), (1, -1), (1, 1), (-1, 1)))
        there = numpy.isfinite(corners).all(axis=(1, 2))
        drawn = collections.PolyCollection(corners[there], linewidths=0, zorder=2)
        if kind.scale is None:
            drawn.set_facecolor(style.OURS[0])
        else:
            drawn.set(cmap=kind.scale.colours, norm=kind.scale.norm, array=numpy.ma.masked_invalid(found["value"][there]))
        axes.add_collection(drawn, autolim=False)

    def draw_membranes(self, axes, kind, found):
        for number, (body, _) in enumerate(kind.bodies):
            chosen = found["body"] == body
            if not chosen.any():
                continue
            look = {"color": style.MEMBRANES[number % len(style.MEMBRANES)], "zorder": 4}
            for piece in pieces(found["places"][chosen]):
                axes.plot(*piece.T, linewidth=1.2, marker="o", markersize=1.6, **look)
            mass = found["mass"][chosen]
            heavy = found["places"][chosen][mass > HEAVY * numpy.median(mass)]
            axes.plot(*heavy.T, linestyle="none", marker="o", markersize=6, **look)

    @property
    def handles(self):
        """What the legend explains: which bodies are gas, fluid, solid or membrane."""
        found = []
        for kind in self.kinds.values():
            if kind.name == "membrane":
                found += [lines.Line2D([], [], color=style.MEMBRANES[k % len(style.MEMBRANES)], label=named)
                          for k, (_, named) in enumerate(kind.bodies)]
            else:
                colour = kind.scale.rgba(kind.scale.low + 0.8 * (kind.scale.high - kind.scale.low)) if kind.scale else style.OURS[0]
                found.append(lines.Line2D([], [], linestyle="none", marker="s", color=colour,
                                          label=f"{kind.name}: {short_names([named for _, named in kind.bodies])}"))
        return found
