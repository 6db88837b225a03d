#!/usr/bin/env bash
# Tries a suite's shards with GNU parallel over ssh on one machine: two nodes are two ssh servers on loopback,
# with ports and keys of their own; the machine's own server is not touched.
# usage: try_ssh.sh FOLDER one|all piglit|differential [OPTION of the suite...]
#   one: a node is lost in the middle, and the other takes over its work; all: both are lost, and come back
# As root, each node has its own processes and its own folder of results, so that results are copied over ssh.
set -euo pipefail
# shellcheck source=tests/merge/try_lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/try_lib.sh"

[[ $# -ge 3 && $2 =~ ^(one|all)$ ]] || fail "usage: try_ssh.sh FOLDER one|all piglit|differential [OPTION...]"
folder=$(mkdir -p "$1" && cd "$1" && pwd)
lost=$2 suite=$3
shift 3
shards=${SHARDS:-8}
out=$root/out
declare -A nodes=()

make_keys() {
  rm -rf "$folder/ssh"
  mkdir "$folder/ssh"
  chmod 700 "$folder/ssh"
  ssh-keygen -q -t ed25519 -N '' -f "$folder/ssh/host"
  ssh-keygen -q -t ed25519 -N '' -f "$folder/ssh/user"
  local node port=$((20000 + RANDOM % 20000))
  for node in one other; do
    port=$((port + 1))
    cat >"$folder/ssh/server-$node" <<TEXT
Port $port
ListenAddress 127.0.0.1
HostKey $folder/ssh/host
PidFile $folder/ssh/$node.pid
AuthorizedKeysFile $folder/ssh/user.pub
PasswordAuthentication no
UsePAM no
StrictModes no
TEXT
    cat >>"$folder/ssh/client" <<TEXT
Host $node
  HostName 127.0.0.1
  Port $port
TEXT
  done
  cat >>"$folder/ssh/client" <<TEXT
Host *
  User $(id -un)
  IdentityFile $folder/ssh/user
  IdentitiesOnly yes
  UserKnownHostsFile $folder/ssh/known
  StrictHostKeyChecking accept-new
  LogLevel ERROR
TEXT
  if [[ $(id -u) == 0 ]]; then mkdir -p /run/sshd; fi
}

start_node() {
  local results=$out/$suite/shards
  mkdir -p "$results"
  if [[ $(id -u) == 0 ]]; then
    # shellcheck disable=SC2016  # they are arguments of the shell in the node's own namespace
    unshare --mount --pid --fork --kill-child --mount-proc bash -c \
      'mount -t tmpfs results "$0" && exec /usr/sbin/sshd -D -f "$1" -E "$2"' \
      "$results" "$folder/ssh/server-$1" "$folder/ssh/$1.log" &
  else
    /usr/sbin/sshd -D -f "$folder/ssh/server-$1" -E "$folder/ssh/$1.log" &
  fi
  nodes[$1]=$!
  disown # avoids a message about its end
  local tries
  for ((tries = 0; tries < 50; tries++)); do
    ssh -F "$folder/ssh/client" "$1" true 2>/dev/null && return
    sleep 0.2
  done
  fail "the node $1 cannot be reached"
}

kill_node() {
  say "the node $1 is lost, with $(whole_results) of $shards results here"
  kill_tree "${nodes[$1]}"
}

stop() { for pid in "${nodes[@]}"; do kill_tree "$pid"; done; }
trap stop EXIT

engine_run() {
  "$root/dev" "$suite" --engine parallel --shards "$shards" \
    --hosts "ssh -F $folder/ssh/client one,ssh -F $folder/ssh/client other" "$@"
}

serial_run "$@"
make_keys
start_node one
start_node other
say "with two nodes"
rm -rf "$out/$suite/shards"/shard-*.json
engine_run "$@" >"$folder/engine.txt" 2>&1 &
engine=$!
until_results 2 "$engine"
sleep 1
kill_node other
if [[ $lost == all ]]; then kill_node one; fi
status=0
wait "$engine" || status=$?
tail -n 1 "$folder/engine.txt"
say "it ended with $status and $(whole_results) of $shards results"
if [[ $lost == all ]]; then
  [[ $status == 2 ]] || fail "a run without all shards ended with $status"
  start_node one
  start_node other
fi
say "the same command again"
status=0
engine_run "$@" >"$folder/again.txt" 2>&1 || status=$?
grep -E "shards to run|passed" "$folder/again.txt"
[[ $status != 2 ]] || fail "shards are still missing"
must_equal_serial
