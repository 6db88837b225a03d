#!/usr/bin/env bash
# Builds the packages of another architecture in a Debian of that architecture. Runs as root.
# usage: scripts/package_in_chroot.sh ARCHITECTURE FOLDER     FOLDER/arbiter-VERSION is the source; the
#                                                             packages come to lie in FOLDER
set -euo pipefail

root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
# shellcheck source=scripts/dev_lib.sh
source "$root/scripts/dev_lib.sh"
architecture=$1
work=$(readlink -f "$2")
suite=$(debian_release)
base=$(dirname "$work")/build-$architecture.tar
cache=$(dirname "$work")/ccache-$architecture
chroot=$work/chroot

# All mounts are this script's, and go with it.
if [[ -z ${ARBITER_PACKAGE_INSIDE:-} ]]; then
  exec unshare --mount --pid --fork --mount-proc --propagation private -- \
    env ARBITER_PACKAGE_INSIDE=1 "$root/scripts/package_in_chroot.sh" "$@"
fi

inside() { chroot "$chroot" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/tmp LC_ALL=C.UTF-8 \
  DEBIAN_FRONTEND=noninteractive DEB_BUILD_PROFILES=pkg.arbiter.libs CCACHE_DIR=/ccache CCACHE_NOHASHDIR=1 \
  ${SOURCE_DATE_EPOCH:+"SOURCE_DATE_EPOCH=$SOURCE_DATE_EPOCH"} \
  DEB_BUILD_OPTIONS="${DEB_BUILD_OPTIONS:-parallel=$(nproc)}" "$@"; }

# What the packages are built with is kept; it is asked for again, as that may have changed.
step "a $suite of $architecture" >&2
if [[ ! -f $base ]]; then
  mmdebstrap --quiet --format=tar --variant=buildd --architectures="$architecture" "$suite" "$base.part" \
    "deb http://deb.debian.org/debian $suite main"
  mv "$base.part" "$base"
fi
fresh_chroot "$base" "$chroot"
mount -t tmpfs tmpfs "$chroot/dev/shm"
mkdir "$chroot/build"
cp -r "$work"/arbiter-* "$chroot/build/"
source=/build/$(basename "$(echo "$chroot"/build/arbiter-*)")
# Objects of earlier builds lie in the chroot while it builds, and are kept when it fails.
mkdir -p "$cache"
mv "$cache" "$chroot/ccache"
trap 'mv "$chroot/ccache" "$cache"' EXIT
inside apt-get update -qq >&2
inside apt-get install -y -qq --no-install-recommends -o Dpkg::Use-Pty=0 ccache >&2
inside apt-get build-dep -y -qq --no-install-recommends -o Dpkg::Use-Pty=0 "$source/" >&2
step "building the packages of $architecture" >&2
# As the architecture's own programs see the machine: of 32 bits.
inside setarch "$architecture" sh -c "cd $source && dpkg-buildpackage --no-sign --build=any"
find "$chroot/build" -maxdepth 1 -type f -exec cp {} "$work/" \;
umount "$chroot/dev/shm" "$chroot/proc"
mv "$chroot/ccache" "$cache"
trap - EXIT
rm -rf --one-file-system "$chroot"
