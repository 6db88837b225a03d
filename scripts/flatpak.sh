#!/usr/bin/env bash
# The extension for Flatpak of this tree, of the files that git knows, as they stand.
# usage: scripts/flatpak.sh [BRANCH]     24.08 without; docs/use/launchers.md
set -euo pipefail

root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
# shellcheck disable=SC2034  # read by dev_lib.sh
{ out=$root/out; build=$root/build; jobs=$(nproc); }
# shellcheck source=scripts/dev_lib.sh
source "$root/scripts/dev_lib.sh"

branch=${1:-24.08}
id=org.freedesktop.Platform.VulkanLayer.Arbiter
work=$root/build-flatpak
version=$(<"$root/VERSION")
bundle=$out/arbiter-$version-$branch-$(flatpak --default-arch).flatpak

missing=()
for name in org.freedesktop.Platform org.freedesktop.Sdk; do
  flatpak info "$name//$branch" >/dev/null 2>&1 || missing+=("$name//$branch")
done
if [[ ${#missing[@]} -gt 0 ]]; then
  fail "flatpak: not installed: ${missing[*]}
These commands install it, more than 1 GB:
  flatpak remote-add --user --if-not-exists flathub https://dl.flathub.org/repo/flathub.flatpakrepo
  flatpak install --user flathub ${missing[*]}"
fi

step "$id//$branch" >&2
rm -rf --one-file-system "$work/source"
mkdir -p "$work/source" "$out"
git -C "$root" ls-files -z --cached --others --exclude-standard |
  tar -C "$root" --null --files-from=- --ignore-failed-read -cf - | tar -C "$work/source" -xf -
manifest=$work/source/data/flatpak/$id.yml
sed -i "s/24\.08/$branch/" "$manifest"
# Without FUSE, which a container may lack.
flatpak-builder --user --jobs="$jobs" --disable-rofiles-fuse --force-clean --state-dir="$work/state" \
  --repo="$work/repo" "$work/files" "$manifest" >&2
flatpak build-bundle --runtime "$work/repo" "$bundle" "$id" "$branch" >&2
printf '%s\n' "$bundle"
