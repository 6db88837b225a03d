#!/usr/bin/env bash
# Builds the layer and its tests as 32-bit x86 code, and runs them on this machine's processor.
# usage: scripts/i386.sh TREE [TEST...]     without names: all tests that need nothing else of 32 bits
#
# TREE/root gets Debian's i386 packages unpacked, nothing of the running system is changed; TREE/build
# is a cross build, whose programs have the loader and the libraries of TREE/root, Mesa among them. Where the kernel
# runs no 32-bit programs (ia32_emulation=off), qemu does.
set -euo pipefail

root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
out=$root/out
jobs=${ARBITER_JOBS:-$(nproc)}
# shellcheck source=scripts/dev_lib.sh
source "$root/scripts/dev_lib.sh"
# shellcheck source=scripts/sysroot.sh
source "$root/scripts/sysroot.sh"

# Only namespaces of users, of Linux 6.7 and later, have formats of programs of their own, which go with them.
emulate() {
  local formats=/proc/sys/fs/binfmt_misc zeros='\x00\x00\x00\x00\x00\x00\x00\x00' ones='\xff\xff\xff\xff\xff'
  mount -t binfmt_misc binfmt_misc "$formats" ||
    fail "i386: this kernel neither runs 32-bit programs nor has qemu do so"
  printf '%s' ":qemu-i386:M::\x7fELF\x01\x01\x01\x00$zeros\x02\x00\x03\x00:" \
    "$ones\xfe\xfe\x00$ones\xff\xff\xff\xfe\xff\xff\xff:$(command -v qemu-i386):F" >"$formats/register"
}

if [[ -n ${ARBITER_I386_EMULATED:-} ]]; then
  emulate
elif ! arch-test -n i386 >/dev/null; then
  exec unshare --user --map-root-user --mount -- env ARBITER_I386_EMULATED=1 QEMU_CPU=max "$0" "$@"
fi
tree=$(mkdir -p "$1" && cd "$1" && pwd)
shift
export WANTED=$*
triplet=i386-linux-gnu
sysroot=$tree/root
libraries=$sysroot/usr/lib/$triplet:$sysroot/lib/$triplet:$sysroot/usr/lib/$triplet/pulseaudio
loader=$sysroot/lib/ld-linux.so.2

packages=(
  # What is compiled against.
  libc6-dev libstdc++-12-dev llvm-15-dev libgtest-dev libgmock-dev libbenchmark-dev
  nlohmann-json3-dev libfmt-dev libxxhash-dev libtomlplusplus-dev libcli11-dev libglm-dev
  libgl-dev libegl-dev libopengl-dev libglx-dev libglvnd-dev libglvnd-core-dev libx11-dev libxext-dev
  libosmesa6-dev libepoxy-dev libglfw3-dev libpng-dev libjpeg62-turbo-dev libtinyobjloader-dev
  libelf-dev libsdl2-dev libglew-dev
  # What runs: the host's GL, and clients in Python.
  libgl1-mesa-dri libegl-mesa0 libglx-mesa0 python3
)

# Libraries find each other where they were unpacked, and programs start with the unpacked loader, as those
# do that are built here. By RUNPATH, which LD_LIBRARY_PATH goes before.
settle_programs() {
  [[ $tree/settled -nt $tree/unpacked ]] && return
  local file
  while IFS= read -r file; do
    if [[ $(head -c 4 "$file" | tail -c 3) == ELF ]]; then patchelf --set-rpath "$libraries" "$file"; fi
  done < <(find "$sysroot"/{usr/,}"lib/$triplet" "$sysroot"/usr/lib/python3.*/lib-dynload -name '*.so*' -type f \
    ! -name 'ld-linux*' ! -name 'libc.so*' ! -path '*/dri/*' ! -path '*/gconv/*'; echo "$sysroot/usr/lib/$triplet/dri/swrast_dri.so")
  for file in "$sysroot"/usr/bin/python3.[0-9]*; do
    patchelf --set-interpreter "$loader" --set-rpath "$libraries" "$file"
  done
  touch "$tree/settled"
}

# What meson is to use in place of this machine's own.
write_tools() {
  write_llvm_config "$tree" x86
  write_pkg_config "$tree" $triplet
  write_cross_file "$tree" i686-linux-gnu x86 i686
  cat >>"$tree/cross.ini" <<TEXT
[built-in options]
cpp_args = ['--sysroot=$sysroot', '-g1']
cpp_link_args = ['--sysroot=$sysroot', '-Wl,--dynamic-linker=$loader', '-Wl,--enable-new-dtags',
  '-Wl,-rpath,$libraries', '-Wl,-rpath-link,$libraries']

[properties]
needs_exe_wrapper = false
TEXT
}

unpack_sysroot i386 "$tree" "${packages[@]}"
settle_programs
write_tools
configure "$tree/build" --cross-file "$tree/cross.ini" -Dtests=true -Ddemos=true -Dbuilder=disabled \
  -Dllvm=15 -Dosmesa_library="$sysroot/usr/lib/$triplet/libOSMesa.so.8" -Ddebug=false -Db_pch=true
compile "$tree/build"

# Not of the width: what reads sources, what starts other programs of this machine in the layer's
# place of a client, and what asks which libraries the machine itself has installed, as the doctor does:
# it has none of 32 bits. A name ends at * for all that begin so.
others=(
  'include_graph*' 'sub_rooms*' 'tally*' packages 'references*' editors 'real_*'
  tools-options-valgrind tools-doctor merge-suites 'report-*' control-page 'hardening*'
)
meson introspect --tests "$tree/build" | python3 -c '
import fnmatch, json, os, sys
wanted, others = os.environ["WANTED"].split(), sys.argv[1:]
for test in json.load(sys.stdin):
    name = test["name"]
    if name in wanted or (not wanted and not any(fnmatch.fnmatch(name, other) for other in others)):
        print(name)' "${others[@]}" >"$tree/tests"
mapfile -t tests <"$tree/tests"
[[ ${#tests[@]} -gt 0 ]] || fail "i386: no such test"
plain_environment
start_display
# The machine's own too: X servers that tests start.
own=$(g++ -print-multiarch)
export LIBGL_DRIVERS_PATH=$sysroot/usr/lib/$triplet/dri:/usr/lib/$own/dri
export CLIENT_PYTHON=$sysroot/usr/bin/python3
failures=0
meson_tests "$tree/build" --timeout-multiplier 4 "${tests[@]}"
if [[ -z $WANTED ]]; then
  step "differential: interpreter, compiler's GLSL, host, layer"
  counted differential python3 "$root/scripts/run_differential.py" --build "$tree/build" \
    --out "$out/differential-i386" --counts "$results/differential.json"
fi
[[ $failures == 0 ]]
