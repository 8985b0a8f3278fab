#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# tests/fuzz/run.sh SECONDS: libFuzzer on decks, overrides, particle and mesh files, all four at once. Fails on any finding
# and says which bytes make it.
set -euo pipefail
cd "$(dirname "$0")/../.."
duration=${1:?usage: tests/fuzz/run.sh SECONDS}
targets=(deck overrides particles mesh)

cmake --preset fuzz
cmake --build --preset fuzz

work=$(mktemp -d)
mkdir "$work"/{deck,overrides,particles,mesh}
cp tests/thesis-boxes/*.in decks/*.in tests/bad_decks/*.in "$work/deck"
cp tests/meshes/*.msh tests/bad_decks/*.msh "$work/mesh"
cp tests/thesis-boxes/*.par particles/*.par tests/bad_decks/*.par "$work/particles"
printf '%s\n' 'in.tmax=0.5d0' 'IN.Wl = 4' 'reg.nprg(2)=9' 'reg.ipath(1,2)=3,3,3,7' "in.particles='a.par'" "mpm.order='usl'" \
  > "$work/overrides/all"

# Instrumented code takes some twenty times as long as the program: 5 s are a quarter of a second.
fuzz() {  # target
  "build/fuzz/tests/fuzz/fuzz_$1" -dict=tests/fuzz/deck.dict -max_total_time="$duration" -timeout=5 -rss_limit_mb=2048 \
    -max_len=4096 -print_final_stats=1 -artifact_prefix="$work/$1-" "$work/$1" > "$work/$1.log" 2>&1
}

declare -A running
for target in "${targets[@]}"; do
  fuzz "$target" &
  running[$target]=$!
done
trap 'kill "${running[@]}" 2> /dev/null || true' EXIT

failed=0
for target in "${targets[@]}"; do
  if wait "${running[$target]}"; then
    echo "fuzz_$target: $(awk '/number_of_executed_units/ {print $2}' "$work/$target.log") inputs, no finding"
  else
    failed=1
    tail -n 60 "$work/$target.log"
    echo "fuzz_$target: a finding; run build/fuzz/tests/fuzz/fuzz_$target on" "$work/$target"-*
  fi
done
[ "$failed" -eq 1 ] || rm -r "$work"
exit "$failed"
