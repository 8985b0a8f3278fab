# SPDX-License-Identifier: GPL-3.0-or-later
"""Sound decks with one mistake each.

The mistake is a template, set among the items of a sound deck or between its groups. In a template `^` stands before
what the user got wrong, a blank for any gap, `~` for one that ends no line. The place of a mistake is where a user
would put a finger on it: at the name, value or subscript that is wrong, at the variable that lacks its '=' or its
value, at the first value too many, at the quote or the group that is never closed, and where something is missing at
what stands in its place.
"""
import random

import spell

# Items in any order make a deck that runs.
SOUND = {
    "in": ["nx=11", "ny=21", "xleft=0.", "xright=+1.", "ybot=0", "ytop=2.", "tmax=.5", "tstep=1e-5", "dtmax=1.d-5",
           "igen=1", "gravc=-9.81", "cntr=1.", "tol=1e-4", "miter=30", "large=.false.", "wl=6", "wr=6", "wb=4", "wt=1",
           "methd=0", "cyl=0.", "iout(33)=1", "tiout(33)=.01", "units='si'", "iout(30)=1 0,1", "tiout(30)=2*.1 .2"],
    "fluid": ["mu=0.", "gm1=.4", "siep=2.5,2.", "lambda=1.", "coef1=1.", "coef2=1."],
    "regrig": ["nregrig=0"],
    "reg": ["nreg=2", "nvi=4,4", "xvi(1,1)=0.,.5,.5,0.", "yvi(1,1)=0.,0.,1.,1.", "xvi(:,2)=.5,1.,1.,.5",
            "yvi(1:4,2)=0. 0. 1. 1.", "xcenter=.25,.75", "ycenter=.5,.5", "rix=0.,0.", "rex=2*9.", "riy=0.,0.",
            "rey=9.,9.", "nprg=4,4", "densir=1.,.125", "matr(1,1)=1e5,.3", "matr(1,2)=1e5,.3", "ipath(1,1)=4*0",
            "ipath(1,2)=3,3,3,9", "vrx=0.,0.", "vry=0.,0."],
    "points": ["tracked_at(1,1)=.1,.2", "tracked_at(:,2)=.3,.4"],
    "mpm": ["order='musl'", "cfl=1."],
}
BETWEEN = "between"  # a template that stands between two groups

KINDS = {
    "unknown name": {"in": ["^gravity_constant=9.8", "^zzz(3)=1 2", "^x1=.5"], "reg": ["^youngs_modulus(1)=1e5"],
                     "mpm": ["^viscous_force=1."]},
    "misspelt name": {"in": ["^nnx=11", "^xlft=0.", "^tmx=.5", "^tsteps=1e-5", "^iotu(33)=1", "^wll=6"],
                      "reg": ["^densr=1.,.125", "^xvii(1,1)=0.,.5", "^npgr=4,4"], "fluid": ["^gml=.4"]},
    "name of another group": {"in": ["^gm1=.4", "^nreg=2", "^cfl=1."], "reg": ["^nx=11", "^siep(1)=2.5"],
                              "mpm": ["^tstep=1e-5"]},
    "missing =": {"in": ["^nx 11", "^tmax .5", "^wl 6", "^iout(33) 1", "^units 'si'", "^large .true."],
                  "reg": ["^nvi 4,4", "^xvi(1,1) 0.,.5,.5,0.", "^densir 1.,.125"], "mpm": ["^order 'musl'"]},
    "missing value": {"in": ["^nx=", "^tmax =", "^xleft=1*", "^ytop=,"]},
    "doubled =": {"in": ["nx=^=11", "tmax=^=.5", "iout(33)=^=1"], "reg": ["xvi(1,1)=^=0.,.5"]},
    "bad number": {"in": ["tmax=^1.5x", "tmax=^.5e", "gravc=^--5", "gravc=^+-5", "xleft=^0x1F", "ytop=^1_000.",
                          "ytop=^two", "tiout(33)=^1.2.3", "tiout(30)=.1 ^O.1"],
                   "reg": ["xvi(1,1)=0.,.5,^.5.5.,0.", "densir=1.,^l.5", "vrx=2*^1e+"]},
    "bad integer": {"in": ["nx=^11x", "nx=^1e-3", "miter=^3.5", "iout(33)=^one", "wl=^6-", "ny=^2l"],
                    "reg": ["nvi=4,^4.5", "ipath(1,2)=3,3,^E3,9"]},
    "real overflow": {"in": ["gravc=^1e400", "tmax=^1.d309", "xright=^-9.9+999"], "reg": ["vrx=0.,^1.8e308"]},
    "integer overflow": {"in": ["miter=^2147483648", "methd=^-99999999999999999999"],
                         "reg": ["ipath(1,2)=3,3,^3000000000"]},
    "not finite": {"in": ["gravc=^inf", "tol=^nan", "xleft=^-Infinity"], "reg": ["xcenter=.25,^NaN"]},
    "out of its range": {"in": ["nx=^1", "ny=^-21", "tmax=^-1.", "tstep=^0.", "wl=^7", "igen=^2", "cyl=^.5",
                                "iout(30)=1 0,^2"],
                         "fluid": ["gm1=^0."], "reg": ["densir=1.,^-.125", "nvi=4,^21", "nprg=^0,4"]},
    "unknown choice": {"in": ["units=^'imperial'", 'units=^"s~i"'], "mpm": ["order=^'mussel'", "density=^'none'"]},
    "subscript out of range": {"in": ["iout(^61)=1", "tiout(^0)=.1", "iout(^-3)=1", "iout(1:^61)=1", "iout( ^99 )=1"],
                               "reg": ["xvi(1,^21)=0.", "xvi(^21,1)=0.", "matr(^0,1)=1e5", "ipath(1:^5,2)=3",
                                       "nvi(^21)=4", "xvi(:,^0:2)=0."]},
    "wrong rank": {"in": ["iout(^1,2)=1", "tiout(^3,3,3)=.1"], "reg": ["xvi(^1)=0.", "matr(^:)=1e5", "nvi(^1,1)=4"],
                   "points": ["tracked_at(^1)=.1"]},
    "subscript of a scalar": {"in": ["nx(^1)=11", "tmax(^2)=.5", "units(^1)='si'"], "reg": ["nreg(^1)=2"]},
    "bad subscript": {"in": ["iout(^1.5)=1", "iout(^i)=1", "iout(^)=1", "iout(1:^n)=1", "iout(33^=1", "iout(33 ^34)=1",
                             "^iout[33]=1"],
                      "reg": ["xvi(1,^)=0.", "xvi(^,1)=0.", "xvi(1:^'4',1)=0."]},
    "bad section": {"in": ["iout(^1:5:0)=1", "iout(^5:2)=1 1", "tiout(^1:2:-1)=.1"], "reg": ["xvi(^4:1,1)=0."]},
    "past the end": {"in": ["iout(59)=1 0,^1", "iout=60*1,^0", "tiout(58:60)=.1 .1 .1 ^.1", "iout=^61*1",
                            "iout(60)=1,,^1"],
                     "reg": ["xvi(1:2,1)=0. .5,^.5", "ipath(4,20)=9,^9", "nvi=19*4 4 ^4", "matr(20,20)=^2*1."]},
    "two values for one": {"in": ["nx=11 ^12", "tmax=.5,^.6", "large=t ^f", "units='si',^'cgs'", "wl=^2*6"],
                           "fluid": ["gm1=.4 ^1.4"]},
    "text without quotes": {"in": ["units=^si", "particles=^a.par", "particles=^../a.par"],
                            "mpm": ["order=^musl", "density=^cell"]},
    "unclosed quote": {"in": ["units=^'si", 'units=^"si', "particles=^'a.par"], "mpm": ["order=^'musl"]},
    "stray quote": {"in": ["units=^'s'i'", "particles=^'it's'"], "mpm": ['order=^"mu"sl"']},
    "quoted number": {"in": ["nx=^'11'", 'tmax=^".5"', "large=^'true'"], "reg": ["nvi=4,^'4'"]},
    "bad logical": {"in": ["large=^yes", "large=^1", "large=^0.", "large=^.on.", "large=^.x."]},
    "items run together": {"in": ["nx=^11ny=21", "large=^.false.wl=6", "units=^'si'wl=6"],
                           "reg": ["nvi=4,^4nprg=4,4"]},
    "bad repeat": {"in": ["iout(30)=^0*1", "iout(30)=^-2*1", "iout(30)=^2*3*1", "iout(30)=^*1", "tiout(30)=^2.*1."],
                   "reg": ["densir=^00*1.", "nvi=4,^x*4"]},
    "huge repeat": {"in": ["iout(30)=^1000000000*0", "tiout=^99999999999999999999*", "nx=^2*11"],
                    "reg": ["xvi=^401*0."]},
    "wrong comment": {"in": ["wl=6 ^# left\n", "nx=11 ^* note\n", "tmax=.5 \n^c note\n", "large=f ^#note\n"],
                      "reg": ["densir=1.,.125 ^# water\n", "nreg=2\n^C regions\n"]},
    "stray mark": {"in": ["wl=6^)", "wl=6 ^(", "nx=11 ^:", "units='si' ^)"], "reg": ["nreg=2 ^:", "nprg=4^:"]},
    "no ASCII": {"in": ["gravc=^\u22129.81", "nx^\u00a0=11", "nx=^\u00a011", "wl=6^\u2003", "units=^\u2018si\u2019",
                        "^tm\u00e4x=.5"],
                 "reg": ["densir=1.,^\u00b5"]},
    "control byte": {"in": ["nx=11 ^\x0c", "^\x01wl=6", "units='s^\x02i'"], "reg": ["nreg=^\x002"]},
    "unknown group": {BETWEEN: ["^$geometry length=1. $\n", "^&parameters\n a=3, b='x'\n/\n", "^$run_control /\n"]},
    "misspelt group": {BETWEEN: ["^$flud mu=0. $\n", "^&membran law='uniaxial' /\n", "^$regs nreg=2 $end\n"]},
    "blank before the group": {BETWEEN: ["^$~fluid mu=0. $\n", "^&~mpm cfl=1. /\n", "^$~reg nreg=2 $\n"]},
    "group inside a line": {"in": ["wl=6~^$fluid\n", "nx=11~^&reg\n"], "fluid": ["mu=0.~^$reg\n"]},
    "bad end": {"in": ["wl=6~^$~end\n"], "fluid": ["mu=0.~^&~END\n"]},
    "unclosed group": {},
}


class MistakenDeck:
    """A sound deck as it is written, with the mistake of a kind in it, if any."""

    def __init__(self, kind, seed):
        self.rng = random.Random(f"{kind} {seed}")
        self.kind = kind
        self.text = ""
        self.place = None
        self.deck()

    def gap(self):
        self.text += spell.gap(self.rng)

    def mark(self):
        before = self.text.encode()
        self.place = (before.count(b"\n") + 1, len(before) - before.rfind(b"\n"))

    def template(self, template):
        for character in template:
            if character == "^":
                self.mark()
            elif character == " ":
                self.gap()
            else:
                self.text += self.rng.choice(spell.BLANKS) if character == "~" else character

    def deck(self):
        names = list(SOUND)
        self.rng.shuffle(names)
        target = self.rng.choice(list(KINDS.get(self.kind, {})) or [None])
        wrong = self.rng.choice(KINDS[self.kind][target]) if target else ""
        between = self.rng.randrange(len(names)) if target == BETWEEN else None
        self.text = "a title, 'open\n"
        for number, name in enumerate(names):
            if number == between:
                self.template(wrong)
            last_is_open = self.kind == "unclosed group" and number + 1 == len(names)
            self.group(name, wrong if name == target else "", last_is_open)

    def group(self, name, wrong, left_open):
        self.text += spell.blanks(self.rng)
        if left_open:
            self.mark()
        self.text += self.rng.choice("$&") + spell.any_case(self.rng, name)
        self.gap()
        named = wrong.replace("^", "").partition("=")[0].partition(" ")[0]
        items = [item for item in SOUND[name] if item.partition("=")[0] != named] + ([wrong] if wrong else [])
        self.rng.shuffle(items)
        for item in items:
            self.template(item)
            self.text += spell.comma(self.rng) if self.rng.random() < 0.4 else spell.gap(self.rng)
        if not left_open:
            self.text += self.rng.choice(("\n$\n", "/\n", "$end\n", "\n&\n"))
