#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The Debian package in a bare system: it installs, and a plain user runs a shipped deck from a folder of their own and draws
# it. Needs root and debootstrap: tests/package/run.sh PACKAGE.deb [MIRROR]
set -euo pipefail
source "$(dirname "$0")/bare_system.sh"

package=$(realpath "$1")
make_bare_system "${@:2}"
cp "$package" "$root/tether.deb"
in_bare_system apt-get install -q -y --no-install-recommends ./tether.deb > /dev/null
as_user '
  tether decks get sod
  tether sod.in
  tether plot out/sod
  test -s out/sod/fields.png
  tether film out/sod --frames 3
  test -s out/sod/film.mp4
  test -s /usr/share/man/man1/tether.1.gz -o -s /usr/share/man/man1/tether.1
  tether reproduce sod --out out/reproduce --quiet
  bash -c "source /usr/share/bash-completion/completions/tether; COMP_WORDS=(tether de); COMP_CWORD=1; _tether; test \"\${COMPREPLY[0]}\" = decks"
'
echo "the package installs and runs in a bare system"
