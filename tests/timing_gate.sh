#!/usr/bin/env bash
# How well the timing gate detects a slowdown: in how many of 20 tries it finds one of 5 %, and in how many of 100 tries
# without a delay it reports one by mistake. Prints both counts. This is not a test, since the result depends on what
# else the machine does. The program is judged against plumb_delayed, which is the same program with an injected delay
# in our engine (see tests/timing/injected_delay.h); both counts come from the same pair of programs.
#
#   tests/timing_gate.sh PLUMB PLUMB_DELAYED [TRIES WITH] [TRIES WITHOUT] [PERCENT] [further words for plumb check]
set -euo pipefail

plumb=$(realpath -- "${1:?the program}")
delayed=$(realpath -- "${2:?the program with an injected delay, plumb_delayed}")
with=${3:-20} without=${4:-100} percent=${5:-5}
shift $(($# < 5 ? $# : 5))

# Counts the tries in which something was slower; the verdicts go to standard error.
count() {
  local found=0 try said begun seconds=0
  for ((try = 1; try <= $1; ++try)); do
    begun=$(date +%s%N)
    said=$("$delayed" check --time-against "$plumb" "${@:2}" || true)
    seconds=$((seconds + ($(date +%s%N) - begun) / 1000000))
    said=$(sed -n '/^Times:/,$p' <<<"$said")
    [ -n "$said" ] || { echo "no times" >&2; return 1; }
    if grep -q '^  slower' <<<"$said"; then found=$((found + 1)); fi
    printf '[%s/%s] %s\n' "$try" "$1" "$said" >&2
  done
  printf '%s of %s, %s s each\n' "$found" "$1" "$(awk "BEGIN { printf \"%.1f\", $seconds / 1000 / ($1 > 0 ? $1 : 1) }")"
}

printf 'with %s %%: found in %s\n' "$percent" "$(PLUMB_INJECTED_DELAY=$percent count "$with" "$@")"
printf 'without: reported in %s\n' "$(PLUMB_INJECTED_DELAY='' count "$without" "$@")"
cat /proc/loadavg
