#!/usr/bin/env bash
# Tries a suite's shards as a Slurm job array on one machine, as root: a controller and two nodes on loopback,
# with a munge of their own. One node is killed in the middle, and Slurm gives its shard to the other; one task
# is cancelled, and the same command runs it again.
# usage: try_slurm.sh FOLDER piglit|differential [OPTION of the suite...]
set -euo pipefail
# shellcheck source=tests/merge/try_lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/try_lib.sh"

[[ $# -ge 2 ]] || fail "usage: try_slurm.sh FOLDER piglit|differential [OPTION...]"
[[ $(id -u) == 0 ]] || fail "the nodes' daemons want to be root's"
folder=$(mkdir -p "$1" && cd "$1" && pwd)
suite=$2
shift 2
shards=${SHARDS:-8}
out=$root/out
declare -A daemons=()

write_configuration() {
  rm -rf "$folder/slurm"
  mkdir -p "$folder/slurm"/{state,one,other}
  local port=$((20000 + RANDOM % 20000))
  # Nodes may claim any resources; these allow one task at a time on each node.
  cat >"$folder/slurm/slurm.conf" <<TEXT
ClusterName=trial
SlurmctldHost=$(hostname -s)(127.0.0.1)
SlurmctldPort=$port
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$folder/slurm/munge.socket
StateSaveLocation=$folder/slurm/state
SlurmdSpoolDir=$folder/slurm/%n
SlurmctldPidFile=$folder/slurm/slurmctld.pid
SlurmdPidFile=$folder/slurm/%n.pid
SlurmctldLogFile=$folder/slurm/slurmctld.log
SlurmdLogFile=$folder/slurm/%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmdParameters=config_overrides
SlurmdTimeout=10
ReturnToService=2
MpiDefault=none
NodeName=one NodeAddr=127.0.0.1 NodeHostname=$(hostname -s) Port=$((port + 1)) CPUs=1
NodeName=other NodeAddr=127.0.0.1 NodeHostname=$(hostname -s) Port=$((port + 2)) CPUs=1
PartitionName=trial Nodes=one,other Default=YES MaxTime=INFINITE State=UP
TEXT
  export SLURM_CONF=$folder/slurm/slurm.conf
}

start_munge() {
  head -c 128 /dev/urandom >"$folder/slurm/munge.key"
  chmod 600 "$folder/slurm/munge.key"
  munged --foreground --force --key-file "$folder/slurm/munge.key" --socket "$folder/slurm/munge.socket" \
    --pid-file "$folder/slurm/munge.pid" --log-file "$folder/slurm/munge.log" \
    --seed-file "$folder/slurm/munge.seed" 2>"$folder/slurm/munge.txt" &
  daemons[munge]=$!
  disown # avoids messages about their ends
}

start_node() {
  slurmd -D -N "$1" -f "$SLURM_CONF" >"$folder/slurm/$1.txt" 2>&1 &
  daemons[$1]=$!
  disown
}

until_ready() {
  local tries
  for ((tries = 0; tries < 150; tries++)); do
    [[ $(sinfo --noheader --states=idle --format=%D 2>/dev/null) == "$1" ]] && return
    sleep 0.2
  done
  sinfo >&2 || true
  fail "there are no $1 nodes"
}

# usage: has_in_environment PID NAME=VALUE
has_in_environment() { tr '\0' '\n' 2>/dev/null <"/proc/$1/environ" | grep -qxF "$2"; }

# Kills a node's daemon and the processes it runs, which belong to step daemons that have left it.
end_node() {
  local step task
  kill_tree "${daemons[$1]}"
  for step in $(pgrep -x slurmstepd); do
    for task in $(pgrep -P "$step"); do
      if has_in_environment "$task" "SLURMD_NODENAME=$1" &&
        has_in_environment "$step" "SLURM_CONF=$SLURM_CONF"; then kill_tree "$step"; fi
    done
  done
}

stop() {
  local name
  for name in "${!daemons[@]}"; do end_node "$name"; done
}
trap stop EXIT

engine_run() { "$root/dev" "$suite" --engine slurm --shards "$shards" "$@"; }

serial_run "$@"
write_configuration
start_munge
slurmctld -D -f "$SLURM_CONF" >"$folder/slurm/slurmctld.txt" 2>&1 &
daemons[slurmctld]=$!
disown
start_node one
start_node other
until_ready 2
say "with two nodes"
rm -rf "$out/$suite/shards"/shard-*.json
engine_run "$@" >"$folder/engine.txt" 2>&1 &
engine=$!
until_results 2 "$engine"
sleep 1
job=$(sed -n "s/^Slurm's job \([0-9]*\),.*/\1/p" "$folder/engine.txt")
say "the node other is lost, and task $shards cancelled, with $(whole_results) of $shards results here"
end_node other
scancel "${job}_$shards"
status=0
wait "$engine" || status=$?
tail -n 1 "$folder/engine.txt"
say "it ended with $status and $(whole_results) of $shards results"
[[ $status == 2 ]] || fail "a run without all shards ended with $status"
say "the same command again"
status=0
engine_run "$@" >"$folder/again.txt" 2>&1 || status=$?
grep -E "shards to run|passed" "$folder/again.txt"
[[ $status != 2 ]] || fail "shards are still missing"
must_equal_serial
