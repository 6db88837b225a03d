#!/usr/bin/env bash
# Tests how scripts/dev_lib.sh counts the steps of a suite, with planted failures.
# shellcheck disable=SC2016,SC2034,SC2154,SC2317  # steps are evaluated later, variables are read and set by dev_lib.sh
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
out=$(mktemp -d)
build=$out/build
trap 'rm -rf "$out"' EXIT
# shellcheck source=scripts/dev_lib.sh
source "$root/scripts/dev_lib.sh"
passed=0

pass_python_wrapper # as ./dev does
# A script that stands in for Python is passed by.
(
  mkdir "$out/wrapper"
  printf '#!/bin/sh\nexec "%s" "$@"\n' "$(command -v python3)" >"$out/wrapper/python3"
  chmod +x "$out/wrapper/python3"
  real=$(command -v python3)
  PATH=$out/wrapper:$PATH
  [[ $(command -v python3) == "$out/wrapper/python3" ]]
  pass_python_wrapper
  [[ $(readlink -f "$(command -v python3)") == $(readlink -f "$real") ]]
)
passed=$((passed + 1))

# usage: suite STATUS LAST_LINE COMMANDS   runs a suite of these steps, in a shell of its own
suite() {
  local status=0 said
  rm -f "$results/.process" # as after another suite's end
  said=$(
    set +o pipefail # as a script may have it
    fresh_results
    eval "$3"
    finish_results
  ) 2>"$out/errors" || status=$?
  if [[ $status != "$1" || $(tail -n 1 <<<"$said") != "$2" ]]; then
    printf '%s\n%s\nstatus %d, and not %d with: %s\n' "$3" "$said" "$status" "$1" "$2" >&2
    exit 1
  fi
  passed=$((passed + 1))
}

# Runs steps as a script of their own does, which may end early.
script() { (eval "$1"); }

# Leaves a part as a runner with --counts does.
left() { echo '{"name": "left", "passed": 3, "failed": 0, "skipped": 0}' >"$2"; }

suite 0 "1 passed, 0 failed, 0 skipped" 'counted a true'
suite 1 "1 passed, 1 failed, 0 skipped" 'counted a true; counted b false'
suite 1 "0 passed, 1 failed, 0 skipped" 'counted a no-such-command'
suite 0 "5 passed, 0 failed, 0 skipped" 'counted a echo "5 passed, 0 failed, 0 skipped"'
suite 0 "1 passed, 0 failed, 0 skipped" 'counted --once a echo "5 passed, 0 failed, 0 skipped"'
suite 1 "5 passed, 1 failed, 0 skipped" 'counted a sh -c "echo 5 passed, 0 failed, 0 skipped; exit 3"'
suite 0 "1 passed, 0 failed, 1 skipped" 'counted a true; counted b sh -c "echo skipped: needs root: x; exit 77"'
suite 1 "1 passed, 1 failed, 1 skipped" 'counted a true; counted b sh -c "echo skipped: no such row; exit 77"'
suite 1 "0 passed, 0 failed, 0 skipped" 'true'
suite 1 "0 passed, 1 failed, 0 skipped" 'of_parts a false'
suite 1 "0 passed, 1 failed, 0 skipped" 'of_parts a script "needed b false; counted c true"'
suite 1 "2 passed, 1 failed, 0 skipped" 'of_parts a script "counted b true; counted c true; exit 4"'
suite 0 "3 passed, 0 failed, 0 skipped" 'counted_whole a left'
suite 0 "" 'counted_whole a test --shard = --shard; exit'
suite 0 "" 'is_part --shard 1/2; is_part --shard=1/2; ! is_part --shards 2; exit'
# A suite may have nothing to run, if it says so and each of its skips has an owner.
lacks='counted a sh -c "echo skipped: needs root; exit 77"'
suite 1 "0 passed, 0 failed, 1 skipped" "$lacks"
suite 0 "0 passed, 0 failed, 1 skipped" "$lacks; may_skip=yes finish_results; exit"
suite 1 "0 passed, 0 failed, 0 skipped" 'may_skip=yes finish_results; exit'
suite 1 "0 passed, 1 failed, 1 skipped" 'counted a sh -c "echo skipped: no such row; exit 77"; may_skip=yes finish_results; exit'

# Stands in for python3: a host is there, lacks or is another one by this status, and nothing runs over it.
# usage: of_host STATUS
of_host() {
  stood_in=$1
  python3() {
    case "$*" in
      *"hosts.py check"*)
        echo "skipped: no driver of NVIDIA's here"
        return "$stood_in"
        ;;
      */tests/hosts/judge.py* | */compare.py*) echo "over $TEST_HOST: $*" >>"$out/ran" ;;
      *"release.py --machine"*) echo "over $TEST_HOST" ;;
      *) command python3 "$@" ;;
    esac
  }
}
suite 0 "0 passed, 0 failed, 1 skipped" 'of_host 77; over_host nvidia; may_skip=yes finish_results; exit'
[[ ! -f $out/ran && ! -f $results/.machine ]]
suite 1 "0 passed, 1 failed, 0 skipped" 'of_host 1; over_host zink'
[[ ! -f $out/ran && ! -f $results/.machine ]]
suite 0 "5 passed, 0 failed, 0 skipped" 'of_host 0; over_host softpipe'
[[ $(grep -c "over softpipe" "$out/ran") == 4 && $(cat "$results/.machine") == "over softpipe" ]]
suite 0 "" 'use_host softpipe; [[ $GALLIUM_DRIVER == softpipe ]]; use_host llvmpipe; [[ -z ${GALLIUM_DRIVER:-}${TEST_HOST:-} ]]; exit'
for words in "" nosuch "softpipe nosuch"; do
  # shellcheck disable=SC2086  # words
  [[ $("$root/dev" hosts $words 2>&1) == "hosts: no host "*"there are: llvmpipe softpipe zink nvidia" ]]
  passed=$((passed + 1))
done
# Another suite runs; then one that has ended.
sleep 60 >/dev/null &
other=$!
of_other=$(process "$other")
suite 1 "" 'echo "$of_other" >"$results/.process"; fresh_results'
suite 0 "1 passed, 0 failed, 0 skipped" 'echo "$other 1" >"$results/.process"; fresh_results; counted a true'
kill "$other"
wait "$other" || true
suite 0 "1 passed, 0 failed, 0 skipped" 'echo "$of_other" >"$results/.process"; fresh_results; counted a true'
# Patterns of names of tests.
meson() { echo '[{"name": "api-b"}, {"name": "api-a"}, {"name": "other-api"}]'; }
[[ $(tests_like tree 'api-*') == $'api-a\napi-b' ]] || { echo "tests_like: not those of the pattern" >&2; exit 1; }
if tests_like tree 'none*'; then echo "tests_like: a pattern of no test passed" >&2; exit 1; fi
passed=$((passed + 2))

echo "$passed passed, 0 failed, 0 skipped"
