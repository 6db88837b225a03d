#!/usr/bin/env bash
# The packages of out/packages as a user of a bare Debian has them: lintian, installed in a clean
# chroot, used, purged, and nothing of them left. Runs as root.
# usage: scripts/check_packages.sh [FOLDER [RELEASE]]     FOLDER has the packages, or else out/packages;
#                                                         they are used in that release of Debian, or else bookworm
set -euo pipefail

root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
out=$root/out
# shellcheck source=scripts/dev_lib.sh
source "$root/scripts/dev_lib.sh"
packages=$(readlink -f "${1:-$root/out/packages}")
work=$root/build-package/check
chroot=$work/chroot
suite=${2:-bookworm}

# All mounts are this script's, and go with it.
if [[ -z ${ARBITER_CHECK_INSIDE:-} ]]; then
  exec unshare --mount --pid --fork --mount-proc --propagation private -- \
    env ARBITER_CHECK_INSIDE=1 "$root/scripts/check_packages.sh" "$packages" "$suite"
fi
mkdir -p "$results"
failures=0

debs() { find "$packages" -maxdepth 1 -name "*_$1.deb" | sort; }
[[ -n $(debs "$(dpkg --print-architecture)") ]] || fail "$packages has no packages; ./dev package builds them"
native=$(dpkg --print-architecture)
architectures=$native
[[ $native == amd64 ]] && architectures=amd64,i386

# The record of a build names packages that lie beside it.
step "lintian"
mkdir -p "$work"
rm -rf --one-file-system "$work/lintian"
mkdir "$work/lintian"
find "$packages" -maxdepth 2 -type f -exec cp -t "$work/lintian" {} +
# The first entry of a changelog would close a bug of Debian's only if these went into its archive.
needed --once lintian lintian --allow-root --info --fail-on error,warning \
  --suppress-tags initial-upload-closes-no-bugs "$work"/lintian/*.changes
rm -r "$work/lintian"

# The bare system is kept; a check starts from a copy of it. The main archive alone: all packages of
# two architectures must have one version, and another archive's may be newer in one of them.
step "a clean $suite"
base=$work/base-$suite-${architectures/,/-}.tar
if [[ ! -f $base ]]; then
  mmdebstrap --quiet --format=tar --variant=minbase --architectures="$architectures" "$suite" "$base.part" \
    "deb http://deb.debian.org/debian $suite main"
  mv "$base.part" "$base"
fi
fresh_chroot "$base" "$chroot"
mount --rbind /dev "$chroot/dev"
mkdir "$chroot/packages" "$chroot/checks"
mapfile -t files < <(debs "$native"; [[ $native == i386 ]] || debs i386 | grep -E '/lib' || true)
cp "${files[@]}" "$chroot/packages/"
cp "$root"/debian/tests/{installed,widths,display.py} "$chroot/checks/"
inside() { chroot "$chroot" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/tmp LC_ALL=C.UTF-8 \
  DEBIAN_FRONTEND=noninteractive "$@"; }
# Without a network: the displays of the machine have abstract sockets, which a chroot does not hide.
used() { unshare --net -- chroot "$chroot" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/tmp LC_ALL=C.UTF-8 "$@"; }
install=(apt-get install -y -qq -o Dpkg::Use-Pty=0)
inside apt-get update -qq

# What the packages stand on and what the checks use is there before, so that what is compared
# afterwards is these packages alone.
step "what the packages ask for"
mapfile -t wanted < <(inside sh -c 'apt-get install -s ./packages/*.deb' |
  awk '/^Inst/ { print $2 }' | grep -vxE "$(for file in "${files[@]}"; do
    dpkg-deb -f "$file" Package
  done | sort -u | sed 's/$/(:[a-z0-9]+)?/' | paste -sd '|')")
gears=(mesa-utils xvfb python3 pkgconf)
inside "${install[@]}" --no-install-recommends "${wanted[@]}" "${gears[@]}"

# Paths, kinds and contents, without what dpkg and apt write of themselves.
contents() {
  (cd "$chroot" && find . -xdev \( -path ./proc -o -path ./dev -o -path ./tmp -o -path ./packages \
    -o -path ./checks -o -path ./var/log -o -path ./var/cache/apt -o -path ./var/lib/apt \
    -o -path ./var/lib/dpkg -o -path ./var/cache/ldconfig -o -name __pycache__ \) -prune -o -type f -printf '%p %m ' \
    -exec sha256sum {} \; -o ! -type f -printf '%p %y %m %l\n' | sort
    grep -h . var/lib/dpkg/diversions var/lib/dpkg/statoverride 2>/dev/null || true
    (cd var/lib/dpkg/info && ls))
}
step "installed"
contents >"$work/before"
needed --once installed inside sh -c "${install[*]} ./packages/*.deb && apt-get check -qq"
step "used"
counted used used python3 /checks/installed -v
counted used-widths used python3 /checks/widths -v
step "purged"
counted --once purged inside sh -c "apt-get purge -y -qq -o Dpkg::Use-Pty=0 $(
  sed -n 's/^ *sudo apt purge //p' "$root/README.md")"
contents >"$work/after"
counted --once nothing-left diff -u "$work/before" "$work/after"
[[ $failures == 0 ]] && step "packages: installed, used and purged without a trace"

if [[ $architectures == *i386 ]]; then
  step "32-bit programs where the layer is 64-bit alone"
  inside "${install[@]}" --no-install-recommends mesa-utils-bin:i386 busybox:i386 libgl1-mesa-dri:i386 \
    libegl1:i386 libgl1:i386
  needed --once installed-64 inside sh -c "${install[*]} ./packages/*_amd64.deb"
  counted widths-of-64 used python3 /checks/widths -v
  if [[ -n $(debs i386) ]]; then
    step "and where it has both widths"
    needed --once installed-both inside sh -c "${install[*]} ./packages/*.deb"
    counted widths-of-both used python3 /checks/widths -v
    step "programs for Windows of both widths"
    inside "${install[@]}" --no-install-recommends wine wine64 wine32:i386
    mkdir "$chroot/checks/real"
    cp "$root"/tests/real_programs_vs_host/{wine_widths,cases,picture,session}.py "$chroot/checks/real/"
    python3 "$root/tests/real_programs_vs_host/wine_widths.py" --build-clients "$chroot/checks/clients"
    counted wine used python3 /checks/real/wine_widths.py --clients /checks/clients --out /tmp/wine
  fi
fi
[[ $failures == 0 ]]
