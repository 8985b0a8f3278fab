# SPDX-License-Identifier: GPL-3.0-or-later
"""A fluid in a box of cells and the bodies in it, at one time."""
import numpy
from matplotlib import colors, patches

import style
from scene import box_in_space, elements, in_space, liquid, quantities, triangles
from scene.box_in_space import FLUID, OBSTACLE, STONE, VOID

MOST = 98.0  # per cent of the bodies' energy densities of the run: those beyond are drawn as that one


class BoxScene:
    """What mesh.nc and solids.nc of a run hold, record by record."""

    def __init__(self, run):
        self.fluid = run.fields("mesh")
        self.box, self.times = self.fluid.box, self.fluid.times
        self.units = self.fluid.units | self.box.units
        self.shape, self.dim = self.box.shape, self.box.dimension
        self.bodies = run.fields("solids") if run.has("solids") else None
        self.surface = run.fields("surface") if run.has("surface") else None
        self.flow = run.fields("flow") if run.has("flow") else None
        self.faces = elements.topology.outer_faces(self.bodies.elements) if self.dim == 3 and self.bodies else None
        self.in_space = box_in_space.BoxInSpace(self.box) if self.dim == 3 else None
        self.energy = quantities.Scale("energy density", self.bodies.units["energy_density"] if self.bodies else "1")

    def fit_bodies(self, records):
        """The scale of the bodies' energy densities from some records."""
        if not self.bodies:
            return
        samples = numpy.concatenate([self.bodies.at(record)["energy_density"] for record in records])
        self.energy.high = max(float(numpy.nanpercentile(samples, MOST)), 1e-300) if numpy.isfinite(samples).any() else 1.0
        self.energy.extend = "max"

    def record_at(self, time):
        return self.fluid.record(float(time))

    def cells(self, name, record):
        """A field as an array over z (in space), y and x; `speed` is that of the velocities."""
        return quantities.value_of(self.fluid.at(record), name)

    def most(self, name):
        """The largest size of a field over all times, in the fluid's cells."""
        return max(numpy.nanmax(abs(self.in_fluid(name, record)), initial=0) for record in range(len(self.times))) or 1.0

    def in_fluid(self, name, record):
        """A field in the fluid's cells."""
        values = self.fluid.at(record)
        found = quantities.value_of(values, name)[values["kind"] == FLUID]
        return found[numpy.isfinite(found)]

    def limits(self):
        """Of the picture; in space in its pixels."""
        if self.dim == 3:
            return self.in_space.limits
        return tuple(float(self.box.edges[axis][end]) for axis in "xy" for end in (0, -1))

    def draw(self, axes, record, name, scale):
        """The field, obstacles and bodies."""
        axes.set_aspect("equal")
        axes.grid(False)
        if self.dim == 3:
            self.in_space.show(axes, self.image(record, name, scale))
        else:
            self.draw_plane(axes, record, name, scale)

    def draw_plane(self, axes, record, name, scale):
        cells = self.fluid.at(record)
        kind, values = cells["kind"], quantities.value_of(cells, name)
        x, y = self.box.edges["x"], self.box.edges["y"]
        if "surface" in cells:
            liquid.draw_plane(axes, x, y, cells, values, scale)
        elif self.flow:
            if not (kind == VOID).any():
                axes.add_patch(patches.Rectangle((x[0], y[0]), x[-1] - x[0], y[-1] - y[0], facecolor=STONE, zorder=0.5))
            triangles.draw(axes, self.flow.at(self.flow.record(float(self.times[record]))), name, scale)
        else:
            axes.pcolormesh(x, y, numpy.ma.masked_where((kind != FLUID) | ~numpy.isfinite(values), values),
                            cmap=scale.colours, norm=scale.norm, zorder=1)
        if not self.flow or (kind == VOID).any():
            axes.pcolormesh(x, y, numpy.ma.masked_where(kind != OBSTACLE, kind), cmap=colors.ListedColormap([STONE]), zorder=1.5)
        if self.bodies:
            bodies = elements.Elements(self.bodies, "energy density")
            bodies.scales = [self.energy]
            bodies.draw(axes, self.bodies.record(float(self.times[record])))

    def image(self, record, name, scale):
        """The picture of a box in space."""
        cells = self.fluid.at(record)
        share = numpy.nan_to_num(quantities.value_of(cells, name)) / max(scale.high, -scale.low)
        if self.surface:
            wet = liquid.surfaces(self.surface.at(self.surface.record(float(self.times[record]))), cells,
                                  quantities.value_of(cells, name), self.box, scale)
            return self.in_space.draw(cells["kind"], 0 * share, wet + self.surfaces(record), scale, False)
        return self.in_space.draw(cells["kind"], share, self.surfaces(record), scale, name == "speed")

    def surfaces(self, record):
        """The bodies at that time, coloured by their energy density."""
        if not self.bodies:
            return []
        values = self.bodies.at(self.bodies.record(float(self.times[record])))
        places = numpy.stack([values[part] for part in "xyz"], axis=1)
        if not numpy.isfinite(places).all():
            return []
        colours = self.energy.rgba(numpy.nan_to_num(values["energy_density"]))[:, :3]
        return [in_space.surface_of(places, self.faces, colours)]


def has_smoke(fluid):
    """Whether there is smoke in some snapshots."""
    return "smoke" in fluid.names and any(fluid.at(record)["smoke"].max() > 0 for record in (0, len(fluid) // 2, -1))


def field_that_matters(run):
    """Smoke where there is any; pressure where weight or open sides give it a level; else the speed."""
    fluid, values = run.fields("mesh"), run.deck_values
    if has_smoke(fluid):
        return "smoke"
    if "surface" in fluid.names:
        return "speed"
    if values.get("coupled.fluid_in") == "cavities":
        return "speed"
    opened = any(values.get(f"coupled.side({side})") == "open" for side in range(1, 7))
    return "p" if opened or values.get("in.gravc") else "speed"


def is_painted(fields, name):
    """Whether a name is a colour for a liquid, not that of a field."""
    return "surface" in fields.names and name not in fields.names and colors.is_color_like(name)


class BoxLayer:
    """A layer of a box: a field of the fluid, obstacles, and bodies coloured by their energy density. A liquid may have
    one colour instead, whose name then is given."""

    def __init__(self, run, name=None):
        self.scene = BoxScene(run)
        self.fields, self.times = self.scene.fluid, self.scene.times
        painted = name is not None and is_painted(self.fields, name)
        self.name = field_that_matters(run) if painted else name or field_that_matters(run)
        self.scale = quantities.Scale(self.name, quantities.unit(self.fields, self.name))
        if painted:
            self.scale.own = colors.ListedColormap([name])
        elif self.name == "speed" and "surface" in self.fields.names:
            self.scale.own = liquid.WATER
        self.scales = ([] if painted else [self.scale]) + ([self.scene.energy] if self.scene.bodies else [])
        self.axes_names = ("x", "y") if self.scene.dim == 2 else None

    def limits(self, records):
        return self.scene.limits()

    def fit(self, records):
        samples = [self.scene.in_fluid(self.name, record) for record in records]
        self.scale.fit([*samples, numpy.zeros(1)], 0.0 if self.name == "smoke" else 0.1)
        if self.scene.dim == 3 and not self.scene.surface:
            self.scale.bar = box_in_space.bar_of(self.scale)
        self.scene.fit_bodies([record for record in records if self.scene.bodies])

    def draw(self, axes, record):
        self.scene.draw(axes, record, self.name, self.scale)

    def image(self, record):
        """The picture of a box in space."""
        return self.scene.image(record, self.name, self.scale)

    @property
    def handles(self):
        """What the legend explains."""
        kinds = self.fields.at(0)["kind"]
        found = [patches.Patch(facecolor=STONE, label="obstacle")] if (kinds == OBSTACLE).any() else []
        if self.scene.dim == 2 and self.scene.bodies:
            found.append(patches.Patch(fill=False, edgecolor=style.BEFORE["color"], label="body at the start"))
        return found
