# SPDX-License-Identifier: GPL-3.0-or-later
"""The variables that the generators set: group -> name -> (kind, shape, allowed values), as tether's table has them."""

ANY, NOT_NEGATIVE, POSITIVE = "any", "not negative", "positive"

GROUPS = {
    "in": {
        "nx": ("integer", (), range(2, 999)), "ny": ("integer", (), range(2, 999)), "iprint": ("integer", (), ANY),
        "igen": ("integer", (), (0, 1, 3)), "gravc": ("real", (), ANY), "xleft": ("real", (), ANY),
        "xright": ("real", (), ANY), "ybot": ("real", (), ANY), "ytop": ("real", (), ANY),
        "cntr": ("real", (), (0, 1)), "tmax": ("real", (), POSITIVE), "tstep": ("real", (), POSITIVE),
        "dtmax": ("real", (), POSITIVE), "tplt": ("real", (), ANY), "tol": ("real", (), ANY),
        "miter": ("integer", (), ANY), "large": ("logical", (), ANY), "methd": ("integer", (), ANY),
        "wl": ("integer", (), (0, 1, 4, 5, 6)), "wr": ("integer", (), (0, 1, 4, 5, 6)),
        "wb": ("integer", (), (0, 1, 4, 5, 6)), "wt": ("integer", (), (0, 1, 4, 5, 6)),
        "iout": ("integer", (60,), (0, 1)), "tiout": ("real", (60,), POSITIVE), "cyl": ("real", (), (0, 1)),
        "particles": ("text", (), ANY)},
    "fluid": {
        "mu": ("real", (), NOT_NEGATIVE), "gm1": ("real", (), POSITIVE), "siep": ("real", (20,), NOT_NEGATIVE),
        "lambda": ("real", (), NOT_NEGATIVE), "coef1": ("real", (), NOT_NEGATIVE),
        "coef2": ("real", (), NOT_NEGATIVE)},
    "regrig": {"nregrig": ("integer", (), range(9))},
    "reg": {
        "nreg": ("integer", (), range(21)), "nvi": ("integer", (20,), range(21)), "xvi": ("real", (20, 20), ANY),
        "yvi": ("real", (20, 20), ANY), "xcenter": ("real", (20,), ANY), "ycenter": ("real", (20,), ANY),
        "rix": ("real", (20,), NOT_NEGATIVE), "rex": ("real", (20,), NOT_NEGATIVE),
        "riy": ("real", (20,), NOT_NEGATIVE), "rey": ("real", (20,), NOT_NEGATIVE),
        "nprg": ("integer", (20,), range(1, 99)), "densir": ("real", (20,), POSITIVE),
        "matr": ("real", (20, 20), ANY), "ipath": ("integer", (4, 20), ANY), "vrx": ("real", (20,), ANY),
        "vry": ("real", (20,), ANY)},
    "points": {
        "heavy": ("real", (1000,), POSITIVE), "tracked": ("logical", (1000,), ANY),
        "tracked_at": ("real", (2, 100), ANY)},
}
REQUIRED = ("nx", "ny", "xleft", "xright", "ybot", "ytop", "tmax", "tstep")
