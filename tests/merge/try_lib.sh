# shellcheck shell=bash disable=SC2154  # folder, out and suite are of the scripts that read this
# Shared parts of try_ssh.sh and try_slurm.sh. They run a suite on one machine, then with an engine whose
# nodes are killed in the middle, then repeat the command; at the end both reports must be equal.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)

say() { printf '\n--> %s (%d:%02d)\n' "$*" $((SECONDS / 60)) $((SECONDS % 60)); }

fail() {
  printf 'try: %s\n' "$*" >&2
  exit 1
}

# Kills all processes of a node with their descendants, as a loss of power would.
kill_tree() {
  local child
  kill -STOP "$1" 2>/dev/null || return 0
  for child in $(pgrep -P "$1"); do kill_tree "$child"; done
  kill -KILL "$1" 2>/dev/null || true
}

whole_results() { find "$out/$suite/shards" -name 'shard-*.json' 2>/dev/null | wc -l; }

# usage: until_results COUNT PID   waits for result files while the engine runs
until_results() {
  while (($(whole_results) < $1)); do
    kill -0 "$2" 2>/dev/null || return 0
    sleep 0.2
  done
}

# usage: serial_run OPTION...   leaves its report in $folder/serial.json
serial_run() {
  say "one machine, one run"
  "$root/dev" "$suite" "$@" >"$folder/serial.txt" 2>&1 || true
  tail -n 1 "$folder/serial.txt"
  cp "$out/$suite/report.json" "$folder/serial.json"
}

# usage: must_equal_serial   checks the shards' results of any engine
must_equal_serial() {
  say "the report of the shards against that of one machine"
  "$root/tests/merge/merge.py" --against "$folder/serial.json" "$out/$suite/shards"/shard-*.json |
    tail -n 2
  [[ ${PIPESTATUS[0]} != 2 ]] || fail "they differ"
}
