#!/usr/bin/env bash
# Tests ./plumb in checkouts that hold nothing but it, with stubs of the tools that it calls, and which Node.js CMake takes.
# shellcheck disable=SC2016  # what stubs expand
set -euo pipefail
source_dir=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
work=$(mktemp -d)
chmod 755 "$work"
trap 'rm -rf "$work"' EXIT
failed=0

fail() { printf 'FAILED: %s\n' "$*" >&2; failed=1; }

# stub FILE LINE...: an executable script.
stub() {
  mkdir -p "$(dirname -- "$1")"
  printf '%s\n' '#!/bin/sh' "${@:2}" >"$1"
  chmod 755 "$1"
}

checkout() { mkdir -p "$1"; cp "$source_dir/plumb" "$1/"; }

# expect WHAT CODE TEXT COMMAND...: the command ends with the code and says the text.
expect() {
  local what=$1 code=$2 text=$3 status=0 said
  said=$("${@:4}" 2>&1 </dev/null) || status=$?
  [ "$status" = "$code" ] || fail "$what: exit code $status, should be $code: $said"
  case $said in *"$text"*) ;; *) fail "$what: said \"$said\", should say \"$text\"" ;; esac
}

tools=$work/tools
stub "$tools/dpkg-query" 'case $* in *nodejs|*npm) ;; *) printf installed ;; esac'
stub "$tools/apt-get" 'echo "nothing is to be installed"; exit 9'
stub "$tools/cmake" 'case $1 in --preset) mkdir -p build/release/reports; : >build/release/build.ninja ;; --build)
printf "#!/bin/sh\necho ran \$*\n" >"$2/reports/plumb"; chmod 755 "$2/reports/plumb" ;; esac'
old_node=$work/node16/node
stub "$old_node" 'case $1 in --version) echo v16.20.0 ;; *) echo 16 ;; esac'
stub "$work/node16/npm" 'exit 1'
new_node=$work/node18/node
stub "$new_node" 'case $1 in --version) echo v18.0.0 ;; *) echo 18 ;; esac'
stub "$work/node18/npm" 'exit 0'

# A checkout that cannot be written to, with a finished build. Root can write anywhere.
checkout "$work/read only"
stub "$work/read only/build/release/reports/plumb" 'echo ran "$@"'
chmod -R a-w "$work/read only"
user=()
[ "$(id -u)" != 0 ] || user=(setpriv --reuid=65534 --regid=65534 --clear-groups)
expect "a read-only checkout with a build" 0 "ran list" "${user[@]}" "$work/read only/plumb" list
expect "tests in a read-only checkout" 2 "cannot write to" "${user[@]}" "$work/read only/plumb" test
chmod -R u+w "$work/read only"

# An old Node.js before a new one.
checkout "$work/node"
expect "Node.js 16 first in PATH" 0 "ran list" env "PATH=$tools:$work/node16:$work/node18:$PATH" "$work/node/plumb" list
mkdir "$work/page"
printf '%s\n' 'cmake_minimum_required(VERSION 3.25)' 'project(page LANGUAGES CXX)' 'add_library(plumb_flags INTERFACE)' \
  "add_subdirectory(\"$source_dir/reports/web\" web)" >"$work/page/CMakeLists.txt"
expect "CMake with Node.js 16 first in PATH" 0 "Configuring done" \
  env "PATH=$work/node16:$work/node18:$PATH" cmake -S "$work/page" -B "$work/page/build" -G Ninja
grep -q "^PLUMB_NODE:.*=$new_node\$" "$work/page/build/CMakeCache.txt" ||
  fail "CMake takes $(grep '^PLUMB_NODE:' "$work/page/build/CMakeCache.txt")"

# Paths that CMake and Ninja cannot handle.
for name in "it's" 'a "b"' "a\$b" 'a;b' 'a#b'; do
  checkout "$work/$name"
  expect "a checkout in $name" 2 "cannot build in $work/$name: CMake and Ninja cannot handle" "$work/$name/plumb" list
done

exit "$failed"
