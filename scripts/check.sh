#!/usr/bin/env bash
# What a change must satisfy besides the tests: format, include graph, linters, generated
# files, tidy.
# shellcheck disable=SC2317  # the checks are called by part()
# usage: check.sh BUILD_TREE|--quick [RESULTS]     RESULTS: a folder for the counts
# --quick leaves out what needs a build tree. All parts run; the status says whether any complained.
set -uo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$1
failures=0
# shellcheck source=scripts/dev_lib.sh
source "$root/scripts/dev_lib.sh"
results=${2:-$(mktemp -d)}

part() {
  local before=$failures
  step "$1"
  counted --once "$@"
  if [[ $failures == "$before" ]]; then echo "ok"; else echo "complaints above"; fi
}

sources() { git -C "$root" ls-files -- "$@" | sed "s|^|$root/|"; }

check_format() { sources '*.cpp' '*.h' | xargs -r clang-format --dry-run --Werror; }

# Each checker first shows that it finds what is planted.
check_graph() {
  local checker
  for checker in include_graph/{include_graph,sub_rooms} \
    references/{references,sentences,comments,version,copyright,workflows}; do
    python3 "$root/tests/$checker.py" --self-test && python3 "$root/tests/$checker.py" "$root" ||
      return 1
  done
}

# In the flags of a tree without precompiled headers, which would hide what a header lacks.
check_headers() {
  python3 "$root/tests/lone_headers/lone_headers.py" --self-test &&
    python3 "$root/tests/lone_headers/lone_headers.py" "$root" "$build"
}

check_python() { (cd "$root" && git ls-files -- '*.py' bench/run tests/fuzz/run | xargs -r flake8); }

check_shell() { (cd "$root" && git ls-files -- dev .ci/run '*.sh' | xargs -r shellcheck -x); }

# Lists of files in Meson: one entry a line, so that two changes rarely meet in one.
check_meson() {
  ! git -C "$root" grep -nE "'[^']+\.cpp', *'[^']+\.cpp', *'[^']+\.cpp'" -- '*meson.build'
}

# A subject has 72 characters at most and names one thing. Merges have subjects of their own.
check_subjects() {
  ! git -C "$root" log --no-merges -20 --format='%h %s' |
    awk '{ subject = substr($0, index($0, " ") + 1) } length(subject) > 72 || index(subject, ";")' | grep .
}

check_generated() {
  python3 "$root/docs/generate.py" --check --build "$build" &&
    python3 "$root/docs/interface/write.py" "$build" --check &&
    python3 "$root/bench/chart.py" --check &&
    python3 "$root/docs/tour_map.py" --check &&
    python3 "$root/editors/generate.py" --check
}

# Each file has a holder and a licence whose text is there; a file without any, planted, is found.
check_reuse() {
  local planted found=true
  planted=$(mktemp -d)
  echo planted >"$planted/planted.txt"
  if reuse --root "$planted" lint &>/dev/null; then
    echo "reuse does not see a file without a licence"
    found=false
  fi
  rm -r "$planted"
  $found && (cd "$root" && reuse lint)
}

# clang-tidy needs each file's flags: it looks at what the tree compiles.
check_tidy() {
  python3 "$root/scripts/tidy.py" --self-test >/dev/null &&
    python3 "$root/scripts/tidy.py" "$build" "$root/out/tidy"
}

part "format" check_format
part "include graph, names in comments and docs, English" check_graph
part "Python" check_python
part "shell" check_shell
part "subjects of commits" check_subjects
part "lists of Meson" check_meson
if [[ $build != --quick ]]; then
  part "headers by themselves" check_headers
  part "generated files" check_generated
  part "copyright" check_reuse
  part "tidy" check_tidy
fi
[[ $failures == 0 ]]
