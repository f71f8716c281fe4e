#!/usr/bin/env bash
# Fails if a retired word is used anywhere: reports/glossary.md and the field have better ones. Each line below is a
# pattern (git grep -iE), then what to write instead, then the files that may still use it (readers of older formats).
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."

failed=0
while IFS='|' read -r pattern instead except; do
  [ -n "$pattern" ] || continue
  paths=(. ':!tests/words.sh' ':!CHANGELOG.md' ':!*package-lock.json')
  for path in $except; do paths+=(":!$path"); done
  status=0
  found=$(git grep -nIiE -e "$pattern" -- "${paths[@]}") || status=$?
  case $status in
    0) printf 'retired: "%s"; write "%s":\n%s\n' "$pattern" "$instead" "$(cut -c1-160 <<<"$found")"; failed=1 ;;
    1) ;;
    *) echo "cannot look for \"$pattern\"" >&2; exit 3 ;;
  esac
done <<'WORDS'
\bcontenders?\b|engine|tests/benchmarks/main.cpp reports/history/schema.cpp reports/history/snapshot.cpp tests/reports/history/schema_test.cpp tests/reports/history/snapshot_test.cpp
\bentrants?\b|engine configuration
\byardsticks?\b|reference solution
\bonlookers?\b|observer
\boffences?\b|regression
\bpacers?\b|timing worker
\bwavers?\b|unstable|reports/gate/baseline.cpp tests/reports/gate/baseline_test.cpp
\bleavers?\b|moved proxy
\baskers?\b|batched query
\bsymptoms?\b|finding
\brungs?\b|parameter step
\bwitness|closed form, reference solution
\bneedless\b|redundant
\bspoil[st]\b|mutates
how-manieth|index
share of allowed|error / tolerance
times allowed|error / tolerance
revealed\b|not reported|reports/run/report_json.cpp tests/reports/gate/baseline_test.cpp tests/reports/history/snapshot_test.cpp tests/reports/run/report_json_test.cpp tests/reports/web
\bhangs? on\b|depends on
\btells? of\b|describes, reports
\bdear\b|expensive
\bwhoever\b|if anyone
\bnobody knows\b|unknown
\bknows nothing\b|supports only
so it shall be|accept
issue that asked|the reason itself
ScalarContacts::solve_pair|a name that exists
see accurate\.cpp|a name that exists
looks_ahead\.h|StatedErrors::looks_ahead
\bfates?\b|failure mode, outcome
\brubs?\b|friction|engine tests/engine scenarios/tracker
\bsweeps?\b|iterations; continuous collision|engine tests/engine reference/faults/engine
\bkeep_points\b|contact persistence
\bpush_to\b|apply accumulated impulse
\bforesee|predicted impact velocity change
\bquiet path\b|cached static island
\brouse|wake|engine tests/engine
\blay down\b|put to sleep
\bput back\b|clamp to the time of impact
\btremors?\b|tolerance, low motion|engine tests/engine
\bunpushed\b|ballistic restore|engine tests/engine
\bmore_sweeps\b|extra rigid iterations|engine tests/engine
\bslow_impact\b|restitution threshold|engine tests/engine
\bfind_again\b|mid-step re-collision|engine tests/engine
\bmass_[ab]\b|inv_mass_a|engine tests/engine reference/faults/engine
\blanes_?run\b|batch|engine tests/engine
\blanes_?kind\b|constraint type|engine tests/engine
\bcarry_out\b|the verb of what it does
\bsame_enough\b|a name that exists
\breference/loads\.h|a name that exists
PLUMB_SLOWDOWN|plumb_delayed
WORDS
exit "$failed"
