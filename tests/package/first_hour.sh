#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The first hour as README has it, in a bare system, by a user who may use sudo: ./quickstart, and after it alone what README
# says of sweeps, logarithmic figures, films, mpirun and the package; then ./quickstart once more and ./quickstart install.
# Needs root and debootstrap, and half an hour: tests/package/first_hour.sh [MIRROR]
set -euo pipefail
source "$(dirname "$0")/bare_system.sh"
project=$(realpath "$(dirname "$0")/../..")

readme_lines() {  # pattern; README's commands that have it, without what is said of them
  grep -E "^\(?(build|cd build|mpirun|\./quickstart).*$1" "$project/README.md" | sed 's/ *# .*//' ||
    { echo "README has no command with $1" >&2; return 1; }
}

make_bare_system "$@"
git clone -q "$project" "$root/home/user/tether"
in_bare_system chown -R user /home/user/tether

if as_user "cd tether; ./quickstart" 2> "$root/refused"; then
  echo "quickstart did not say that it needs root"
  exit 1
fi
grep -q "sudo is not there" "$root/refused"
grep -q "apt-get install .*libeigen3-dev" "$root/refused"

in_bare_system apt-get install -q -y --no-install-recommends sudo > /dev/null
echo "user ALL=(ALL) NOPASSWD: ALL" > "$root/etc/sudoers.d/user"
as_user "cd tether; time ./quickstart; test -s out/sod/profiles.png" 2>&1 | tee "$root/said"
grep -q "^building [1-9][0-9]* units: about [1-9][0-9]* minutes" "$root/said"
as_user "cd tether; ./quickstart" | grep "stay as they are"
for what in "sweep decks/studies/sod-convergence" "plot .*--log" "film" "oversubscribe" "cpack"; do
  readme_lines "$what" | while read -r line; do as_user "cd tether; $line"; done
done
as_user "cd tether; ./quickstart install; cd ~; tether decks get sod; tether sod.in; tether plot out/sod"
echo "the first hour goes as README says"
