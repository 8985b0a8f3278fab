# SPDX-License-Identifier: GPL-3.0-or-later
"""Which snapshots show a run: some that are as far apart as each other, or more of them while the bodies move most."""
import re

import numpy

MOST_PANELS = 6
EVEN = 0.02  # of the time between panels, by which a snapshot may be off
REACHED = 0.75  # of the run's time that panels must cover
LIVELY = 0.7  # of the largest variety
MOST_OF_PATH, SOON = 0.6, 0.3  # a motion that has made so much of its path in so much of the time is over early
SEEN = 0.02  # of the domain's width: a motion of less is not seen
CENTRES = re.compile(r"body_[xyz]_\d+$")


def telling(run, times):
    """The numbers of the snapshots that show a run, of all their times."""
    early = [path for path in paths_of(run, times) if len(times) > MOST_PANELS and is_early(path, times)]
    if early:
        return while_it_moves(early[0], times)
    return liveliest(even_sets(times), lambda records: variety(run, times[records]))


def paths_of(run, times):
    """The way that centres of mass have made up to these times where it is seen, and smoke in coming and going."""
    bodies = changes(run, [name for name in run.history.columns if CENTRES.match(name)], times)
    smoke = changes(run, [name for name in run.history.columns if name == "smoke_mass"], times)
    return [path for path, seen in ((bodies, SEEN * width_of(run)), (smoke, 0)) if path[-1] > seen]


def changes(run, columns, times):
    """The sum of all changes of columns up to these times."""
    steps = sum(abs(numpy.diff(run.history[name], prepend=run.history[name][:1])) for name in columns)
    return numpy.interp(times, run.history["time"], numpy.nancumsum(steps)) if columns else numpy.zeros(len(times))


def width_of(run):
    """The width of a run's domain; nothing where its deck is lost."""
    right, left = (float(run.deck_values.get(f"in.{side}", 0.0)) for side in ("xright", "xleft"))
    return right - left


def is_early(path, times):
    """Whether most of the motion is over in the first part of a run."""
    return numpy.interp(SOON, (times - times[0]) / (times[-1] - times[0]), path) > MOST_OF_PATH * path[-1]


def while_it_moves(path, times, most=MOST_PANELS):
    """Snapshots between which as much happens, half of it the motion and half of it time."""
    passed = 0.5 * path / path[-1] + 0.5 * (times - times[0]) / (times[-1] - times[0])
    return sorted({int(abs(passed - target).argmin()) for target in numpy.linspace(0, 1, most)})


def are_even(times, end, count):
    """Numbers of so many snapshots that are as far apart as each other up to one of them; None where there are none."""
    targets = numpy.linspace(times[0], times[end], count)
    records = [int(abs(times - target).argmin()) for target in targets]
    even = abs(times[records] - targets).max() <= EVEN * (targets[1] - targets[0])
    return records if even and len(set(records)) == count else None


def even_sets(times, most=MOST_PANELS):
    """Sets of snapshots that are as far apart as each other, from the first to the last or nearly; the best come first."""
    ends = [end for end in range(len(times) - 1, 0, -1) if times[end] - times[0] > REACHED * (times[-1] - times[0])]
    found = []
    for counts in ((most, most - 2), (most - 1,), (3,)):
        for end in ends:
            found += [records for count in counts if (records := are_even(times, end, count))]
    return found or [sorted({0, len(times) - 1})]


def liveliest(sets, variety_of):
    """The first set whose variety is not far below that of any: a swing is not seen by snapshots that are a period apart."""
    varieties = [variety_of(records) for records in sets]
    return next(records for records, here in zip(sets, varieties) if here >= LIVELY * max(varieties))


def variety(run, times):
    """How much the kinetic energy differs between some times."""
    energy = run.history["energy_kinetic"] if "energy_kinetic" in run.history else 0 * run.history["time"]
    return float(numpy.nan_to_num(numpy.interp(times, run.history["time"], energy).std()))
