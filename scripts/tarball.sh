#!/usr/bin/env bash
# A folder that runs from wherever it is unpacked: out/arbiter-VERSION-ARCHITECTURE.tar.xz
# usage: scripts/tarball.sh [BUILD]           BUILD, a tree of these options without
#        scripts/tarball.sh --check [FILE]    uses the file of this version, or FILE (scripts/check_tarball.sh)
#
# The command finds the layer from where it lies itself. Libraries that a machine without the build's
# packages may lack are beside the layer (scripts/private_libraries.sh); those of a desktop are the machine's.
set -euo pipefail

root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
# shellcheck disable=SC2034  # read by dev_lib.sh
{ out=$root/out; build=$root/build; jobs=$(nproc); }
# shellcheck source=scripts/dev_lib.sh
source "$root/scripts/dev_lib.sh"

version=$(<"$root/VERSION")
architecture=$(dpkg --print-architecture 2>/dev/null || uname -m)
name=arbiter-$version-$architecture
work=$root/build-package/tarball
SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git -C "$root" log -1 --format=%ct 2>/dev/null || date +%s)}
export SOURCE_DATE_EPOCH

if [[ ${1:-} == --check ]]; then
  exec "$root/scripts/check_tarball.sh" "${2:-$out/$name.tar.xz}"
fi
tree=${1:-$root/build-tarball}
if [[ $# == 0 ]]; then
  configure "$tree" -Dprefix=/usr -Dbuildtype=release -Dtests=false -Ddemos=true -Dbuilder=enabled \
    -Dsource_paths=false "-Dcpp_args=-ffile-prefix-map=$root=." -Db_pch=true
  compile "$tree"
fi

step "$name"
rm -rf "$work"
mkdir -p "$work/$name"
DESTDIR=$work/staged meson install -C "$tree" --no-rebuild --quiet
prefix=$(meson introspect --buildoptions "$tree" | python3 -c '
import json, sys
print(next(one["value"] for one in json.load(sys.stdin) if one["name"] == "prefix"))')
cp -a "$work/staged$prefix/." "$work/$name/"
# What only links libraries is of a development package.
find "$work/$name" -name 'libGLX_arbiter.so' -delete
mkdir -p "$work/$name/share/doc/arbiter/docs"
# Two pictures have licences of their own, which debian/copyright names.
cp -a "$root"/{README,CONTRIBUTING,SECURITY,CHANGELOG}.md "$root/LICENSE" "$root/debian/copyright" \
  "$work/$name/share/doc/arbiter/"
cp -a "$root"/docs/{README.md,use,write,driver,design,reference,pictures} "$work/$name/share/doc/arbiter/docs/"
mkdir "$work/$name/share/doc/arbiter/docs/results"
cp -a "$root"/docs/results/{*.md,*.json,pictures} "$work/$name/share/doc/arbiter/docs/results/"
cp -a "$root/editors" "$work/$name/share/arbiter/editors"

mapfile -t programs < <(find "$work/$name/bin" "$work/$name/libexec" -type f -executable)
for program in "${programs[@]}"; do strip --strip-unneeded "$program"; done
find "$work/$name/lib" -name '*.so*' -type f ! -path '*/preload/*' -exec strip --strip-unneeded {} +
"$root/scripts/private_libraries.sh" "$work/$name" "${programs[@]}"

mkdir -p "$out"
pack "$work" "$name" "$out/$name.tar.xz"
printf '%s\n' "$out/$name.tar.xz"
