#!/usr/bin/env bash
# Runs the tests of the rasterizer and of its machine code as AArch64 code, under qemu, on any machine.
# usage: scripts/arm64.sh TREE [TEST...]
#
# TREE/root gets Debian's arm64 libraries unpacked, nothing of the running system is changed; TREE/build
# is a cross build of the tests that need no GL.
set -euo pipefail

root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
out=$root/out
jobs=$(nproc)
# shellcheck source=scripts/dev_lib.sh
source "$root/scripts/dev_lib.sh"
# shellcheck source=scripts/sysroot.sh
source "$root/scripts/sysroot.sh"
tree=$(mkdir -p "$1" && cd "$1" && pwd)
shift
triplet=aarch64-linux-gnu
sysroot=$tree/root

packages=(
  libc6-dev libstdc++-12-dev llvm-15-dev libgtest-dev libgmock-dev libbenchmark-dev
  nlohmann-json3-dev libfmt-dev libxxhash-dev libtomlplusplus-dev libcli11-dev libglm-dev
  libgl-dev libegl-dev libopengl-dev libglvnd-dev libglvnd-core-dev libx11-dev libxext-dev
  libosmesa6-dev libepoxy-dev libglfw3-dev libpng-dev libjpeg62-turbo-dev libtinyobjloader-dev libelf-dev
)

# What meson is to use in place of this machine's own.
write_tools() {
  write_llvm_config "$tree" aarch64
  write_pkg_config "$tree" $triplet
  write_cross_file "$tree" $triplet aarch64 aarch64 "exe_wrapper = ['qemu-aarch64', '-L', '$sysroot']"
  cat >>"$tree/cross.ini" <<TEXT
[built-in options]
cpp_args = ['--sysroot=$sysroot']
cpp_link_args = ['--sysroot=$sysroot', '-Wl,-rpath-link,$sysroot/usr/lib/$triplet:$sysroot/lib/$triplet']
TEXT
}

unpack_sysroot arm64 "$tree" "${packages[@]}"
if [[ ! -f $tree/build/build.ninja ]]; then
  write_tools
  meson setup "$tree/build" "$root" --cross-file "$tree/cross.ini" -Ddemos=false -Dllvm=15
fi

# Without names: the rooms that make machine code or run it.
meson introspect --tests "$tree/build" | python3 -c '
import json, sys
wanted = sys.argv[1:]
for test in json.load(sys.stdin):
    name = test["name"]
    if name in wanted or (not wanted and name.startswith(("jit-", "swrast-"))):
        print(name)' "$@" >"$tree/tests"
mapfile -t tests <"$tree/tests"
[[ ${#tests[@]} -gt 0 ]] || { echo "arm64: no such test" >&2; exit 2; }
# The emulator itself ends a forked child of a process with threads that starts another, and keeps a
# table of every page of what a test reserves, which takes all memory there is.
export GTEST_FILTER='-*WorkAfterFork*:*CodeLiesBesideItsConstants*'
compile "$tree/build"
failures=0
meson_tests "$tree/build" --timeout-multiplier 20 "${tests[@]}"
[[ $failures == 0 ]]
