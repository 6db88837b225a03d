#!/usr/bin/env bash
# What a change must satisfy besides the tests: format, include graph, generated files, tidy.
# shellcheck disable=SC2317  # the checks are called by part()
# usage: check.sh BUILD_TREE; all parts run, the status says whether any complained.
set -uo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$1
status=0

part() {
  printf '\n==> %s\n' "$1"
  shift
  if "$@"; then echo "ok"; else
    status=1
    echo "complaints above"
  fi
}

sources() { git -C "$root" ls-files -- "$@" | sed "s|^|$root/|"; }

check_format() { sources '*.cpp' '*.h' | xargs -r clang-format --dry-run --Werror; }

check_graph() {
  python3 "$root/tests/include_graph/include_graph.py" "$root" &&
    python3 "$root/tests/include_graph/include_graph.py" --self-test
}

check_generated() {
  python3 "$root/docs/generate.py" --check --build "$build" &&
    python3 "$root/editors/generate.py" --check
}

# Only what the tree compiles: clang-tidy needs each file's flags.
check_tidy() {
  python3 -c '
import json, sys
for entry in json.load(open(sys.argv[1] + "/compile_commands.json")):
    print(entry["file"])' "$build" | sort -u |
    (cd "$build" && xargs -r realpath) | grep "^$root/\(src\|demos\)/" | grep -v "_test\.cpp$" |
    xargs -r -P "$(nproc)" -n 4 clang-tidy -p "$build" --quiet 2>/dev/null
}

part "format" check_format
part "include graph" check_graph
part "generated files" check_generated
part "tidy" check_tidy
exit "$status"
