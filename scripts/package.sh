#!/usr/bin/env bash
# Debian packages of this tree, of the files that git knows, as they stand.
# usage: scripts/package.sh     packages of this machine's architecture in out/packages
set -euo pipefail

root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
out=$root/out
# shellcheck source=scripts/packages.sh
source "$root/scripts/packages.sh"
# shellcheck source=scripts/dev_lib.sh
source "$root/scripts/dev_lib.sh"

[[ $# == 0 ]] || fail "package: $1: packages are built for this machine's architecture alone"
architecture=$(dpkg --print-architecture)
version=$(dpkg-parsechangelog -l "$root/debian/changelog" -S Version)
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

rm -rf "$work"
copy_tree "$source"
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
mkdir -p "$out/packages"
rm -f "$out"/packages/*_"$architecture".*
cp "$work"/*.deb "$work"/*.changes "$work"/*.buildinfo "$out/packages/"
