#!/usr/bin/env bash
# Fails if a retired word is used anywhere: reports/glossary.md and the field have better ones. Each line below is a
# pattern (git grep -iE), then what to write instead, then the files that may still use it (readers of older formats).
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."

failed=0
while IFS='|' read -r pattern instead except; do
  [ -n "$pattern" ] || continue
  paths=(. ':!tests/words.sh' ':!*package-lock.json')
  for path in $except; do paths+=(":!$path"); done
  if found=$(git grep -nIiE -e "$pattern" -- "${paths[@]}" | cut -c1-160); then
    printf 'retired: "%s"; write "%s":\n%s\n' "$pattern" "$instead" "$found"
    failed=1
  fi
done <<'WORDS'
WORDS_TABLE
WORDS
exit "$failed"
