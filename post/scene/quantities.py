# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers of a snapshot that are drawn, and the one scale on which all snapshots of a figure have them."""
from dataclasses import dataclass

import numpy
from matplotlib import cm, colors

import style

SPEED_PARTS = ("vx", "vy", "vz")
# What is drawn in which colours; what has no line here is drawn about 0.
COLOURS = {"von Mises stress": "YlOrRd", "energy density": "YlOrRd", "stress": "YlOrRd", "speed": "Blues", "smoke": "gray_r",
           "pressure": "viridis", "density": "viridis"}
# Of all others: colours about 0, or from the least to the largest where one sign has no more than a share of the other.
BEYOND = 1e-6  # of a scale: a bar has an arrow for numbers that are farther outside
BOTH_SIGNS, ONE_SIGN, OTHER_SIGN = "PRGn_r", "viridis", 0.02
NAMES = {"p": "pressure", "smoke": "density of smoke"}


def von_mises(values):
    """Von Mises stress of a snapshot's stresses."""
    xx, yy, zz = (values[name] for name in ("sxx", "syy", "szz"))
    shear = sum(values[name]**2 for name in ("sxy", "syz", "sxz") if name in values)
    return numpy.sqrt(0.5 * ((xx - yy)**2 + (yy - zz)**2 + (zz - xx)**2) + 3 * shear)


def speed(values):
    """Size of the velocity."""
    return numpy.sqrt(sum(values[part]**2 for part in SPEED_PARTS if part in values))


DERIVED = {"von Mises stress": (von_mises, "sxx"), "speed": (speed, "vx")}
ALIASES = {"energy density": "energy_density"}


def value_of(values, name):
    """A quantity of a snapshot by its name: a field of the file, or one that is computed from several."""
    if name in DERIVED:
        return DERIVED[name][0](values)
    return values[ALIASES.get(name, name)]


def has(fields, name):
    """Whether a file's fields give a quantity."""
    needs = DERIVED[name][1] if name in DERIVED else ALIASES.get(name, name)
    return needs in fields.names


def unit(fields, name):
    """The unit of a quantity."""
    return fields.units.get(DERIVED[name][1] if name in DERIVED else ALIASES.get(name, name), "1")


@dataclass
class Scale:
    """The colours of a quantity over all panels of a figure."""

    name: str
    unit: str
    low: float = 0.0
    high: float = 1.0
    extend: str = "neither"
    bar: colors.Colormap | None = None  # where its bar has others
    own: colors.Colormap | None = None  # in place of those of its name

    @property
    def colours(self):
        if self.own is not None:
            return self.own
        about_zero = BOTH_SIGNS if self.low == -self.high else ONE_SIGN
        return COLOURS.get(self.words, about_zero)

    @property
    def words(self):
        """The name without underscores."""
        return self.name.replace("_", " ")

    def fit(self, samples, within=0.0):
        """Takes in the least and the largest of all samples, or leaves out this per cent of them at either end."""
        finite = numpy.concatenate([numpy.ravel(sample) for sample in samples] or [numpy.zeros(1)])
        finite = finite[numpy.isfinite(finite)]
        if len(finite) == 0:
            finite = numpy.zeros(1)
        self.low, self.high = (float(bound) for bound in numpy.percentile(finite, (within, 100 - within)))
        self._widen()
        beyond = BEYOND * (self.high - self.low)
        self.extend = style.extend(finite.min() < self.low - beyond, finite.max() > self.high + beyond)

    def _widen(self):
        if abs(self.low) < 1e-9 * abs(self.high):
            self.low = 0.0
        if self.words not in COLOURS and self.low < 0 < self.high:
            self._widen_about_zero()
        elif self.low > 0 and self.low < 0.5 * self.high or self.name in DERIVED:
            self.low = 0.0
        if self.high - self.low <= 1e-9 * max(abs(self.low), abs(self.high)):
            margin = 0.05 * max(abs(self.high), abs(self.low)) or 1.0
            self.high += margin
            self.low -= margin if self.low != 0 else 0.0

    def _widen_about_zero(self):
        """As far below 0 as above, or from 0 on where the other sign hardly occurs."""
        most = max(-self.low, self.high)
        self.low, self.high = (0.0 if -self.low <= OTHER_SIGN * most else -most), (0.0 if self.high <= OTHER_SIGN * most else most)

    @property
    def norm(self):
        return colors.Normalize(self.low, self.high)

    def mappable(self):
        """What a colour bar is made from."""
        return cm.ScalarMappable(self.norm, self.bar or self.colours)

    def rgba(self, values):
        """Colours of numbers."""
        return self.mappable().to_rgba(values)

    @property
    def label(self):
        return style.label(NAMES.get(self.name, self.words), self.unit)


def largest(bounds):
    """The limits (x least, x largest, y least, y largest) that hold all of these."""
    bounds = numpy.array(list(bounds))
    return (numpy.nanmin(bounds[:, 0]), numpy.nanmax(bounds[:, 1]), numpy.nanmin(bounds[:, 2]), numpy.nanmax(bounds[:, 3]))


def limits_of(places):
    """Limits of places in the plane; of none that is finite, a unit square."""
    places = places[numpy.isfinite(places).all(axis=1)]
    if len(places) == 0:
        return 0.0, 1.0, 0.0, 1.0
    low, high = places.min(axis=0), places.max(axis=0)
    return low[0], high[0], low[1], high[1]
