#!/usr/bin/env bash
# Runs a command in this tree in a Debian of another release, which is made for it. Runs as root.
# usage: scripts/in_debian.sh RELEASE COMMAND...     as in: scripts/in_debian.sh trixie ./dev test
#
# The commit that is checked out is what runs. The bare system and the packages that were fetched are kept in
# build-package, the rest goes; out/test comes back, with what a release says of the machine.
set -euo pipefail

root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
# shellcheck source=scripts/dev_lib.sh
source "$root/scripts/dev_lib.sh"
release=$1
work=$root/build-package/debian-$release
base=$work/base.tar
cache=$work/packages
chroot=$work/chroot

# All mounts are this script's, and go with it.
if [[ -z ${ARBITER_DEBIAN_INSIDE:-} ]]; then
  exec unshare --mount --pid --fork --kill-child --mount-proc --propagation private -- \
    env ARBITER_DEBIAN_INSIDE=1 "$root/scripts/in_debian.sh" "$@"
fi

inside() { chroot "$chroot" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 TERM=dumb \
  DEBIAN_FRONTEND=noninteractive ARBITER_BUILD_OPTIONS="${ARBITER_BUILD_OPTIONS:-}" "$@"; }

step "a bare $release"
mkdir -p "$work" "$cache"
if [[ ! -f $base ]]; then
  mmdebstrap --quiet --format=tar --variant=apt --include=git,ca-certificates "$release" "$base.part" \
    "deb http://deb.debian.org/debian $release main"
  mv "$base.part" "$base"
fi
fresh_chroot "$base" "$chroot"
echo 'Binary::apt-get::APT::Keep-Downloaded-Packages "true";' >"$chroot/etc/apt/apt.conf.d/99keep"
mount --rbind /sys "$chroot/sys"
mount --rbind /dev "$chroot/dev"
mkdir -p "$chroot/var/cache/apt/archives"
mount --bind "$cache" "$chroot/var/cache/apt/archives"
git clone --quiet "file://$root" "$chroot/root/arbiter"
git -C "$chroot/root/arbiter" checkout --quiet "$(git -C "$root" rev-parse HEAD)"

step "$release: ${*:2}"
status=0
inside sh -c 'cd /root/arbiter && "$@"' sh "${@:2}" || status=$?
mkdir -p "$root/out/test"
rm -f "$root"/out/test/*.json
cp "$chroot"/root/arbiter/out/test/*.json "$root/out/test/" 2>/dev/null || true
inside sh -c 'cd /root/arbiter && scripts/release.py --machine' >"$root/out/test/.machine" 2>/dev/null ||
  rm -f "$root/out/test/.machine"
rm -rf "$root/out/debian-$release"
cp -r "$chroot/root/arbiter/out" "$root/out/debian-$release" 2>/dev/null || mkdir -p "$root/out/debian-$release"
cp -r "$chroot/root/arbiter/build/meson-logs" "$root/out/debian-$release/" 2>/dev/null || true
exit "$status"
