# SPDX-License-Identifier: GPL-3.0-or-later
"""Commands import this first: it ends one whose packages are missing, with exit code 4, and says how to install them."""
import importlib.util
import sys

PACKAGES = {"numpy": "python3-numpy", "matplotlib": "python3-matplotlib", "netCDF4": "python3-netcdf4"}


def refuse_without(modules):
    """Ends the command where one of these modules cannot be found."""
    missing = [name for name in modules if importlib.util.find_spec(name) is None]
    if missing:
        print(f"{sys.executable} has no {', '.join(missing)}: sudo apt-get install "
              f"{' '.join(PACKAGES[name] for name in missing)}", file=sys.stderr)
        sys.exit(4)


refuse_without(PACKAGES)
