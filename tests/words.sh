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
\bwavers?\b|unstable|reports/gate/baseline_json.cpp tests/reports/gate/baseline_json_test.cpp
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
revealed\b|not reported|reports/run/report_json.cpp tests/reports/gate/baseline_json_test.cpp tests/reports/history/snapshot_test.cpp tests/reports/run/report_json_test.cpp tests/reports/web
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
PLUMB_SLOWDOWN|plumb_delayed
WORDS
exit "$failed"
