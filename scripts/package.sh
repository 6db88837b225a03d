#!/usr/bin/env bash
# Debian packages of this tree, of the files that git knows, as they stand.
# usage: scripts/package.sh [ARCHITECTURE]     out/packages has those of this machine's, or of another;
#                                              out/packages/debug what a debugger reads
#
# Another architecture whose programs this processor runs (i386 beside amd64) has a Debian of its own in
# build-package, which they are built in; nothing of the running system is changed. They are the libraries
# alone: programs of a second architecture want nothing else.
set -euo pipefail

root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
out=$root/out
# shellcheck source=scripts/packages.sh
source "$root/scripts/packages.sh"
# shellcheck source=scripts/dev_lib.sh
source "$root/scripts/dev_lib.sh"

native=$(dpkg --print-architecture)
architecture=${1:-$native}
[[ $# -le 1 && ($architecture == "$native" || "$native $architecture" == "amd64 i386") ]] ||
  fail "package: ${*: -1}: there is $native here$([[ $native != amd64 ]] || echo ", and i386")"
[[ $architecture == "$native" ]] || arch-test -n "$architecture" >/dev/null ||
  fail "package: a Debian of $architecture builds these packages, and this kernel runs none of its programs"
# The changelog's version is that of the packages of Debian 12. Those of another release have a later one, so that they
# replace these when a system is upgraded.
suffix=
# shellcheck source=/dev/null
if [[ $(debian_release) != bookworm ]]; then suffix=+debian$(source /etc/os-release && echo "${VERSION_ID:-}"); fi
version=$(dpkg-parsechangelog -l "$root/debian/changelog" -S Version)$suffix
work=${ARBITER_PACKAGE_BUILD:-$root/build-package}/$architecture
source=$work/arbiter-$version

# usage: copy_tree FOLDER   the files that git knows, or of an unpacked source package all
copy_tree() {
  mkdir -p "$1"
  if git -C "$root" rev-parse --git-dir >/dev/null 2>&1; then
    git -C "$root" ls-files -z --cached --others --exclude-standard |
      tar -C "$root" --null --files-from=- --ignore-failed-read -cf - | tar -C "$1" -xf -
  else
    tar -C "$root" --exclude='./build*' --exclude=./out -cf - . | tar -C "$1" -xf -
  fi
}

build_here() {
  # debhelper gives the build a home of its own; objects are looked for where the user's are.
  if command -v ccache >/dev/null; then
    CCACHE_DIR=$(ccache --get-config cache_dir)
    export CCACHE_DIR
  fi
  export DEB_BUILD_OPTIONS=${DEB_BUILD_OPTIONS:-parallel=$(nproc)}
  cd "$source"
  if ! dpkg-checkbuilddeps 2>/dev/null; then
    step "installing what the packages are built with" >&2
    as_root env DEBIAN_FRONTEND=noninteractive apt-get update -qq >&2
    as_root env DEBIAN_FRONTEND=noninteractive apt-get build-dep -y -qq --no-install-recommends \
      -o DPkg::Lock::Timeout=300 -o Dpkg::Use-Pty=0 ./ >&2
  fi
  step "building the packages of $architecture" >&2
  dpkg-buildpackage --no-sign --build=binary
}

rm -rf --one-file-system "$work"
copy_tree "$source"
if [[ -n $suffix ]]; then sed -i "1s/([^)]*)/($version)/" "$source/debian/changelog"; fi
if [[ $architecture == "$native" ]]; then
  build_here
else
  as_root "$root/scripts/package_in_chroot.sh" "$architecture" "$work"
fi
# What is installed lies apart from a debugger's files, and from the records of the build, which name both.
packages=$out/packages debug=$out/packages/debug
mkdir -p "$debug"
rm -f "$packages"/*_"$architecture".* "$debug"/*_"$architecture".*
cp "$work"/*.changes "$work"/*.buildinfo "$debug/"
for file in "$work"/*.deb; do
  if [[ $file == *-dbgsym_* ]]; then cp "$file" "$debug/"; else cp "$file" "$packages/"; fi
done
