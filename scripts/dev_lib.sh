# shellcheck shell=bash disable=SC2154  # root, build, out and jobs are of ./dev
# What the verbs of ./dev share: packages, configuring, a display, counting results.

# With the minutes since the verb began.
step() { printf '\n==> %s (%d:%02d)\n' "$*" $((SECONDS / 60)) $((SECONDS % 60)); }

# The stages of a verb that takes minutes: each says which one it is, and how long the rest will take.
# usage: plan SECONDS...   of each stage, on two quiet cores
plan() {
  planned=("$@")
  stage_names=()
  stage_starts=()
}

# usage: stage NAME   the next of the planned ones begins
stage() {
  local at=${#stage_names[@]} done=0 left=0 i
  for i in "${!planned[@]}"; do
    if ((i < at)); then done=$((done + planned[i])); else left=$((left + planned[i])); fi
  done
  # This machine's pace, once there is one.
  if ((done > 0 && SECONDS > 60)); then left=$((left * SECONDS / done)); fi
  stage_names+=("$1")
  stage_starts+=("$SECONDS")
  printf '\n==> %d of %d: %s (%d:%02d, about %d minutes left)\n' $((at + 1)) ${#planned[@]} "$1" \
    $((SECONDS / 60)) $((SECONDS % 60)) $(((left + 59) / 60)) >&2
}

# The time of each stage as a table, and as JSON. usage: stage_times FILE
stage_times() {
  local i end separator=
  printf '\n%8s  %s\n' seconds stage
  printf '[' >"$1"
  for i in "${!stage_names[@]}"; do
    end=${stage_starts[i + 1]:-$SECONDS}
    printf '%8d  %s\n' $((end - stage_starts[i])) "${stage_names[i]}"
    printf '%s{"stage": "%s", "seconds": %d}' "$separator" "${stage_names[i]}" $((end - stage_starts[i])) >>"$1"
    separator=', '
  done
  printf ']\n' >>"$1"
}

# usage: pack FOLDER NAME FILE.tar.xz   NAME in that folder, as bytes of the contents and SOURCE_DATE_EPOCH alone
pack() {
  tar -C "$1" --sort=name --mtime="@$SOURCE_DATE_EPOCH" --owner=0 --group=0 --numeric-owner \
    --mode=u+rwX,go+rX,go-w --pax-option=exthdr.name=%d/PaxHeaders/%f,delete=atime,delete=ctime -cf - "$2" |
    xz -T1 -6 >"$3"
}

fail() {
  printf 'dev: %s\n' "$*" >&2
  exit 1
}

# Where a script stands in for Python, as pyenv's does, the folder of Python itself comes first in PATH: such a script
# takes longer than most of those that it starts, and a suite starts thousands.
pass_python_wrapper() {
  local python folder
  python=$(command -v python3) || return 0
  [[ $(head -c 2 "$python") == '#!' ]] || return 0
  folder=$("$python" -c 'import os, sys; print(os.path.dirname(sys.executable))') || return 0
  if [[ -n $folder ]]; then PATH=$folder:$PATH; fi
}

as_root() {
  if [[ $(id -u) == 0 ]]; then
    "$@"
  elif command -v sudo >/dev/null; then
    sudo "$@"
  else
    fail "packages are missing and neither root nor sudo is at hand; as root: $*"
  fi
}

# Installs the packages of the named groups that are missing.
need() {
  local group
  local -a wanted=()
  for group in "$@"; do
    declare -n list="packages_$group"
    wanted+=("${list[@]}")
  done
  need_packages "${wanted[@]}"
}

is_installed() {
  local package
  for package in ${1//|/ }; do
    [[ $(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null) == installed ]] && return
  done
  return 1
}

# usage: one_of NAME|OTHER...   the first that this release of Debian has, or the first of all
one_of() {
  local package
  for package in ${1//|/ }; do
    if apt-cache show --no-all-versions "$package" >/dev/null 2>&1; then
      echo "$package"
      return
    fi
  done
  echo "${1%%|*}"
}

# Installs what is missing of the named packages. Nothing is asked of the network if nothing is.
need_packages() {
  local package
  local -a lacking=() missing=()
  command -v dpkg-query >/dev/null || return 0
  for package in "$@"; do
    is_installed "$package" || lacking+=("$package")
  done
  [[ ${#lacking[@]} == 0 ]] && return 0
  as_root env DEBIAN_FRONTEND=noninteractive apt-get update -qq >&2
  for package in "${lacking[@]}"; do
    missing+=("$(one_of "$package")")
  done
  # All messages go to stderr: stdout may be the output of `./dev run -- COMMAND`.
  step "installing ${#missing[@]} packages: ${missing[*]}" >&2
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends \
    -o DPkg::Lock::Timeout=300 -o Dpkg::Use-Pty=0 "${missing[@]}" >&2
}

# usage: configure TREE OPTIONS...   a new tree also takes those of ARBITER_BUILD_OPTIONS
configure() {
  local tree=$1
  shift
  if [[ ! -f $tree/build.ninja ]]; then
    step "configuring $(basename "$tree")" >&2
    local -a more=()
    read -ra more <<<"${ARBITER_BUILD_OPTIONS:-}"
    meson setup "$tree" "$root" "$@" "${more[@]}" >&2
  elif [[ $# -gt 0 ]]; then
    # Only a changed option touches the tree; an equal one would still make ninja look again.
    local option
    local -a changed=()
    for option in "$@"; do
      [[ $option == -D* ]] || continue
      option_is "$tree" "${option#-D}" || changed+=("$option")
    done
    if [[ ${#changed[@]} -gt 0 ]]; then meson configure "$tree" "${changed[@]}" >&2; fi
  fi
}

option_is() {
  meson introspect --buildoptions "$1" | python3 -c '
import json, sys
name, _, value = sys.argv[1].partition("=")
for option in json.load(sys.stdin):
    if option["name"] == name:
        have = option["value"]
        have = str(have).lower() if isinstance(have, bool) else str(have)
        sys.exit(0 if have == value else 1)
sys.exit(1)' "$2"
}

# usage: compile TREE [TARGETS...]
compile() {
  # ccache reads a precompiled header of 80 to 170 MB again for each source: that costs more than a
  # tree that is built once can gain.
  if option_is "$1" b_pch=true; then export CCACHE_DISABLE=1; else unset CCACHE_DISABLE; fi
  step "building $(basename "$1") with $jobs jobs" >&2
  ninja -C "$1" -j "$jobs" "${@:2}" >&2
}

# With the tests and demonstrations, while no other verb of this kind does: shards of a run may begin on
# one machine, or in one shared folder, at once.
compile_alone() {
  mkdir -p "$out"
  (
    flock 9
    configure "$build" -Dtests=true -Ddemos=true
    compile "$build"
  ) 9>"$out/.build-lock"
}

# usage: need_engine OPTION...   what `--engine NAME` among the options runs shards with
need_engine() {
  case " $* " in
    *" --engine parallel "* | *" --engine=parallel "*) need parallel ;;
    *" --engine slurm "* | *" --engine=slurm "*) need slurm ;;
  esac
}

# Tests see a plain GL of software, whatever the caller has set.
plain_environment() {
  local name
  for name in $(compgen -e | grep -E '^(ARBITER_|__GLX_|__EGL_|MESA_|GALLIUM_|LIBGL_|VK_|TEST_HOST)' || true); do
    unset "$name"
  done
  unset LD_PRELOAD DEV_RESULTS
  export LIBGL_ALWAYS_SOFTWARE=1
}

# Tests have another GL driver under them. usage: use_host NAME   one of scripts/hosts.py
use_host() {
  local line
  plain_environment
  while IFS= read -r line; do
    export "${line?}"
  done < <(python3 "$root/scripts/hosts.py" environment "$1")
}

# What can be judged over any driver, over the named one. A driver that cannot be here is one skipped case.
# usage: over_host NAME
over_host() {
  local name=$1 suite
  use_host "$name"
  step "$name"
  counted "$name-driver" python3 "$root/scripts/hosts.py" check "$name"
  python3 "$root/scripts/hosts.py" check "$name" >/dev/null || return 0
  for suite in api demonstrations differential; do
    step "$name: $suite"
    counted "$name-$suite" python3 "$root/tests/hosts/judge.py" "$suite" --build "$build" \
      --out "$out/hosts/$name/$suite" --counts "$results/$name-$suite.json"
  done
  step "$name: piglit, the quick set"
  counted "$name-piglit" python3 "$root/tests/piglit/compare.py" --build "$build" --set quick --profiles host,auto \
    --results "$out/hosts/$name/piglit" --counts "$results/$name-piglit.json"
  leave_machine
}

# What a release says of the machine is what this environment draws with, not the release's own.
leave_machine() { python3 "$root/scripts/release.py" --machine >"$results/.machine"; }

# A display of its own on a free number, gone with this script.
start_display() {
  local file
  file=$(mktemp)
  # Without -noreset it starts anew when its last client leaves, and refuses the next meanwhile. It takes 256 clients by
  # itself, and many processors run many tests, some of which run many clients.
  Xvfb -displayfd 3 -screen 0 1280x1024x24 -noreset -maxclients 2048 -nolisten tcp 3>"$file" >/dev/null 2>&1 &
  display_pid=$!
  trap 'kill "$display_pid" 2>/dev/null || true' EXIT
  local tries
  for ((tries = 0; tries < 100; tries++)); do
    [[ -s $file ]] && break
    sleep 0.1
  done
  [[ -s $file ]] || fail "Xvfb did not start"
  DISPLAY=:$(tr -d '\n' <"$file")
  export DISPLAY
  unset WAYLAND_DISPLAY XAUTHORITY
  rm -f "$file"
}

# Prints the name of the release of Debian whose packages this system takes: its own. In another distribution that is
# Debian 12's, which the project is written on.
debian_release() {
  # shellcheck source=/dev/null
  (source /etc/os-release && if [[ $ID == debian ]]; then echo "${VERSION_CODENAME:-sid}"; else echo bookworm; fi)
}

# A Debian of its own, of a tar file, with a /proc of its own. Whoever calls this has a namespace of mounts, with which
# all mounts go. usage: fresh_chroot TAR FOLDER
fresh_chroot() {
  rm -rf --one-file-system "$2"
  mkdir -p "$2"
  tar -C "$2" -xf "$1"
  cp /etc/resolv.conf "$2/etc/resolv.conf"
  echo force-unsafe-io >"$2/etc/dpkg/dpkg.cfg.d/unsafe-io"
  mount -t proc proc "$2/proc"
}

# The parts of a suite leave their counts here; there is one folder, so that one suite runs at a time. A verb that
# another one runs has its own.
results=${DEV_RESULTS:-${out:-}/test}

# Returns a process's number, and when it began: other containers have the same numbers.
process() { echo "$1 $(cut -d ' ' -f 22 "/proc/$1/stat" 2>/dev/null)"; }

# A suite begins with this, so that no results of another one stay if it cannot be built.
fresh_results() {
  local other
  other=$(cat "$results/.process" 2>/dev/null || true)
  if [[ -n $other && $other != "$(process "$$")" && $other == "$(process "${other%% *}")" ]]; then
    fail "another suite runs here, as process ${other%% *}, and leaves its results in $results"
  fi
  rm -rf "$results"
  mkdir -p "$results"
  process "$$" >"$results/.process"
  failures=0
}

# Runs one part of a verb and goes on when it fails: the counts at the end show all parts.
record() {
  "$@" || {
    printf 'dev: failed: %s\n' "$*" >&2
    failures=$((failures + 1))
  }
}

# Runs a step of a suite, and goes on when it fails. Its counts are read from what it prints, if it leaves none in
# NAME.json itself; a step that counts nothing is one case. The output stays in NAME.log, beside that.
# usage: counted [--once] NAME COMMAND...   --once: it is one case, whatever it prints
counted() {
  local - kind=step status=0
  local -x PYTHONUNBUFFERED=1
  set -o pipefail
  if [[ $1 == --once ]]; then
    kind=once
    shift
  fi
  local name=$1 file=$results/${1//[^A-Za-z0-9.-]/-}
  shift
  "$@" 2>&1 | tee "$file.log" || status=$?
  python3 "$root/scripts/tally.py" "$kind" "$name" "$status" "$file.log" "$file.json" || status=1
  case $status in
    0 | 77) ;;
    *)
      printf 'dev: failed: %s\n' "$*" >&2
      failures=$((failures + 1))
      ;;
  esac
}

# A step without which the next ones mean nothing: the counts end with it if it fails.
needed() {
  counted "$@"
  [[ $failures == 0 ]] || exit 1
}

# Runs a script whose steps are counted. If it fails before one of them does, it is a failure itself.
# usage: of_parts NAME COMMAND...
of_parts() {
  local name=$1 status=0
  shift
  "$@" || status=$?
  [[ $status == 0 ]] && return
  failures=$((failures + 1))
  python3 "$root/scripts/tally.py" ended "$name" "$status" "$results"
}

# True of a run whose results only the whole has: a shard, or the bare host alone.
# usage: is_part OPTION...
is_part() {
  case " $* " in
    *" --shard "* | *" --shard="* | *" --bare-only "*) return 0 ;;
  esac
  return 1
}

# Counts a run, and ends with the counts, unless it is a part.
# usage: counted_whole NAME COMMAND...   the command takes --counts FILE
counted_whole() {
  local name=$1
  shift
  if is_part "$@"; then
    "$@"
    return
  fi
  counted "$name" "$@" --counts "$results/$name.json"
  finish_results
}

# Prints the names of a tree's tests that are like a pattern: Meson of Debian 12 takes whole names alone.
# usage: tests_like TREE PATTERN
tests_like() {
  meson introspect --tests "$1" | python3 -c '
import fnmatch, json, sys
print(*sorted({test["name"] for test in json.load(sys.stdin) if fnmatch.fnmatch(test["name"], sys.argv[1])}), sep="\n")
' "$2" | grep .
}

# usage: [whole=whole] meson_tests TREE OPTIONS...   whole: they are all tests of a change
# Where the caller has a folder `reports`, tests that the look for leaks has ended run again.
meson_tests() {
  local tree=$1 log=$1/meson-logs/testlog.json status=0 word found
  local -a again=() words=()
  shift
  for word in "$@"; do
    if [[ $word == *[*?]* ]]; then
      found=$(tests_like "$tree" "$word") || fail "no test is like $word"
      mapfile -t -O ${#words[@]} words <<<"$found"
    else
      words+=("$word")
    fi
  done
  rm -f "$log"
  meson test -C "$tree" --no-rebuild --print-errorlogs --num-processes "$jobs" "${words[@]}" || status=$?
  if [[ $status != 0 && -n ${reports:-} ]]; then
    mapfile -t again < <(python3 "$root/scripts/leaks.py" again "$reports" "$tree" | grep .)
  fi
  if [[ ${#again[@]} -gt 0 ]]; then
    step "again, as leaks could not be looked for: ${again[*]}"
    mv "$log" "$log.first"
    meson test -C "$tree" --no-rebuild --print-errorlogs --timeout-multiplier 8 "${again[@]}" || true
    status=0
    python3 "$root/scripts/leaks.py" merge "$log.first" "$log" || status=1
  fi
  [[ $status == 0 ]] || failures=$((failures + 1))
  record python3 "$root/scripts/tally.py" meson "$log" \
    "$results/meson.json" "${whole:-part}"
}

# Ends with the plain line of counts; a part that failed without a count still fails the verb, and so does a skip that
# has no owner in tests/skips.toml. usage: [may_skip=yes] finish_results   may_skip: all cases may be skipped
finish_results() {
  step "results"
  if [[ -n ${planned:-} ]]; then stage_times "$out/test-times.json"; fi
  python3 "$root/scripts/tally.py" owned "$results" || failures=$((failures + 1))
  python3 "$root/scripts/tally.py" total "$results" ${may_skip:+skips} || failures=$((failures + 1))
  [[ $failures == 0 ]] || exit 1
}
