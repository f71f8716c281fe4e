#!/usr/bin/env bash
# How good a detector the timing gate is: how many of 20 slowdowns of 5 % it finds, and how often it cries wolf in 100
# tries without any. Prints both; no test, since what else the machine does has its say. The program is compared with
# itself; PLUMB_SLOWDOWN (see reference/slowed.h) is only ever heeded by the side that is judged.
#
#   tests/timing_gate.sh PLUMB [TRIES WITH] [TRIES WITHOUT] [PERCENT] [further words for plumb check]
set -euo pipefail

plumb=$(realpath -- "${1:?the program}")
with=${2:-20} without=${3:-100} percent=${4:-5}
shift $(($# < 4 ? $# : 4))

# Of so many tries those in which something was slower; their verdicts go to standard error.
count() {
  local found=0 try said begun seconds=0
  for ((try = 1; try <= $1; ++try)); do
    begun=$(date +%s%N)
    said=$("$plumb" check --time-against "$plumb" "${@:2}" || true)
    seconds=$((seconds + ($(date +%s%N) - begun) / 1000000))
    said=$(sed -n '/^Times:/,$p' <<<"$said")
    [ -n "$said" ] || { echo "no times" >&2; return 1; }
    if grep -q '^  slower' <<<"$said"; then found=$((found + 1)); fi
    printf '[%s/%s] %s\n' "$try" "$1" "$said" >&2
  done
  printf '%s of %s, %s s each\n' "$found" "$1" "$(awk "BEGIN { printf \"%.1f\", $seconds / 1000 / ($1 > 0 ? $1 : 1) }")"
}

printf 'with %s %%: found in %s\n' "$percent" "$(PLUMB_SLOWDOWN=$percent count "$with" "$@")"
printf 'without: reported in %s\n' "$(PLUMB_SLOWDOWN='' count "$without" "$@")"
cat /proc/loadavg
