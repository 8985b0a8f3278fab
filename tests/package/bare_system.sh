# SPDX-License-Identifier: GPL-3.0-or-later
# A bare Debian 12 in a folder of its own, for the scripts here, which source this: `make_bare_system [MIRROR]` sets root to it,
# with a plain user named user; `in_bare_system COMMAND...` runs there as root, `as_user TEXT` has bash run TEXT as that user.

make_bare_system() {
  local mirror=${1:-$(grep -rhoE 'https?://[^ ]*debian/?( |$)' /etc/apt/sources.list /etc/apt/sources.list.d 2>/dev/null | head -1 || true)}
  root=$(mktemp -d)
  chmod 755 "$root"
  trap 'umount "$root/proc" 2>/dev/null || true; rm -rf "$root" "$root.log"' EXIT
  debootstrap --variant=minbase bookworm "$root" $mirror > "$root.log" 2>&1 || { tail -20 "$root.log"; exit 1; }
  mount -t proc proc "$root/proc"
  for file in /etc/apt/apt.conf.d/*; do cp "$file" "$root/etc/apt/apt.conf.d/"; done
  in_bare_system apt-get update -q > /dev/null
  in_bare_system useradd --create-home user
}

in_bare_system() {
  chroot "$root" env DEBIAN_FRONTEND=noninteractive "$@"
}

as_user() {
  chroot "$root" su -s /bin/bash user -c "set -e; cd; $1"
}
