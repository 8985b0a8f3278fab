#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The Debian package in a bare system: it installs, and a plain user runs a shipped deck from a folder of their own and draws
# it. Needs root and debootstrap: tests/package/run.sh PACKAGE.deb [MIRROR]
set -euo pipefail

package=$(realpath "$1")
mirror=${2:-$(grep -rhoE 'https?://[^ ]*debian/?( |$)' /etc/apt/sources.list /etc/apt/sources.list.d 2>/dev/null | head -1 || true)}
root=$(mktemp -d)
chmod 755 "$root"
trap 'umount "$root/proc" 2>/dev/null || true; rm -rf "$root"' EXIT

debootstrap --variant=minbase bookworm "$root" "$mirror" > "$root.log" 2>&1 || { tail -20 "$root.log"; exit 1; }
mount -t proc proc "$root/proc"
cp "$package" "$root/tether.deb"
for file in /etc/apt/apt.conf.d/*; do cp "$file" "$root/etc/apt/apt.conf.d/"; done
chroot "$root" apt-get update -q > /dev/null
chroot "$root" env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends ./tether.deb > /dev/null
chroot "$root" useradd --create-home user
chroot "$root" su user -c '
  set -e
  cd "$HOME"
  tether decks get sod
  tether sod.in
  tether plot out/sod
  test -s out/sod/fields.png
  test -s /usr/share/man/man1/tether.1.gz -o -s /usr/share/man/man1/tether.1
  tether reproduce sod --out out/reproduce --quiet
  bash -c "source /usr/share/bash-completion/completions/tether; COMP_WORDS=(tether de); COMP_CWORD=1; _tether; test \"\${COMPREPLY[0]}\" = decks"
'
echo "the package installs and runs in a bare system"
