#!/usr/bin/env bash
# The files of a release, of the commit that is checked out, built twice and compared byte for byte.
# usage: scripts/artefacts.sh [--only PART,...] [FOLDER]   into out/release/artefacts without
#        scripts/artefacts.sh --compare A B                two folders; a difference is an error that names the file
#
# Parts: debs, debs-i386, tarball, site, vsix, source, notes. The second turn has another folder, umask and time zone,
# and comes later; neither takes objects of a cache. A part that is done on this commit is not done again after a stop.
set -euo pipefail

root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
# shellcheck source=scripts/packages.sh
source "$root/scripts/packages.sh"
# shellcheck source=scripts/dev_lib.sh
source "$root/scripts/dev_lib.sh"
all_parts=(source notes vsix site debs debs-i386 tarball)
work=$root/build-artefacts

# usage: compare A B
compare() {
  local name files=0 wrong=0
  [[ -d $1 && -d $2 ]] || fail "artefacts: no folder $1 or $2"
  while IFS= read -r -d '' name; do
    files=$((files + 1))
    if [[ ! -f $1/$name || ! -f $2/$name ]]; then
      printf 'artefacts: only one of both turns has %s\n' "$name" >&2
    elif ! cmp -s "$1/$name" "$2/$name"; then
      printf 'artefacts: %s differs\n' "$name" >&2
      if command -v diffoscope >/dev/null; then
        diffoscope --max-report-size 20000 "$1/$name" "$2/$name" >&2 || true
      fi
    else
      continue
    fi
    wrong=$((wrong + 1))
  done < <({ find "$1" ! -type d -printf '%P\0'; find "$2" ! -type d -printf '%P\0'; } | sort -zu)
  [[ $files != 0 ]] || fail "artefacts: there is nothing to compare in $1 and $2"
  printf '%d files compared, %d differ\n' "$files" "$wrong"
  [[ $wrong == 0 ]]
}

# usage: make_part PART TREE FILES   builds one part in TREE; its files come to lie in FILES
make_part() {
  local part=$1 tree=$2 files=$3
  case $part in
    source)
      git -C "$tree" -c tar.umask=0022 archive --prefix="arbiter-$version/" HEAD |
        xz -T1 -6 >"$files/arbiter-$version.tar.xz"
      ;;
    notes) "$tree/scripts/changelog.py" --notes >"$files/release-notes.md" ;;
    vsix)
      "$tree/dev" vsix
      cp "$tree/out/arbiter-vscode.vsix" "$files/arbiter-$version.vsix"
      ;;
    site)
      "$tree/dev" docs
      rm -rf "$tree/out/arbiter-$version-site"
      mv "$tree/out/site" "$tree/out/arbiter-$version-site"
      pack "$tree/out" "arbiter-$version-site" "$files/arbiter-$version-site.tar.xz"
      ;;
    debs) "$tree/dev" package && cp "$tree"/out/packages/*_"$native".deb "$files/" ;;
    debs-i386)
      # The Debian that they are built in is kept: both turns have the same.
      local base=build-package/build-i386.tar
      mkdir -p "$tree/build-package" "$root/build-package"
      if [[ -f $root/$base ]]; then cp "$root/$base" "$tree/$base"; fi
      "$tree/dev" package i386
      if [[ ! -f $root/$base ]]; then cp "$tree/$base" "$root/$base"; fi
      cp "$tree"/out/packages/*_i386.deb "$files/"
      ;;
    tarball) "$tree/dev" tarball && cp "$tree/out/arbiter-$version-$native.tar.xz" "$files/" ;;
    *) fail "artefacts: no part $part" ;;
  esac
}

# usage: make_turn NAME TREE   all parts that are asked for and not done yet
make_turn() {
  local turn=$work/$1 tree=$work/$2 part
  if [[ $(cat "$turn/commit" 2>/dev/null) != "$commit" ]]; then
    rm -rf --one-file-system "$turn"
    mkdir -p "$turn/done"
    echo "$commit" >"$turn/commit"
  fi
  for part in "${parts[@]}"; do
    [[ -f $turn/done/$part ]] && continue
    if [[ ! -d $tree ]]; then
      git -C "$root" worktree prune
      git -C "$root" worktree add --quiet --force --detach "$tree" "$commit"
    fi
    step "$1 turn: $part"
    rm -rf --one-file-system "${turn:?}/$part"
    mkdir "$turn/$part"
    make_part "$part" "$tree" "$turn/$part" </dev/null
    touch "$turn/done/$part"
  done
}

drop_trees() {
  local tree
  for tree in "${trees[@]}"; do
    if [[ -d $work/$tree ]]; then git -C "$root" worktree remove --force "$work/$tree"; fi
  done
}

if [[ ${1:-} == --compare ]]; then
  [[ $# == 3 ]] || fail "artefacts: --compare takes two folders"
  compare "$2" "$3"
  exit
fi
parts=("${all_parts[@]}")
whole=(--whole)
if [[ ${1:-} == --only ]]; then
  IFS=, read -ra parts <<<"${2:?}"
  whole=()
  shift 2
fi
[[ $# -le 1 && ${1:-} != -* ]] || fail "artefacts: usage: scripts/artefacts.sh [--only PART,...] [FOLDER]"
folder=$(readlink -m "${1:-$root/out/release/artefacts}")

need artefacts
# What is not committed is of no commit.
[[ -z $(git -C "$root" status --porcelain --untracked-files=no) ]] ||
  fail "artefacts: there are changes that are not committed; git status names them"
commit=$(git -C "$root" rev-parse HEAD)
version=$(<"$root/VERSION")
native=$(dpkg --print-architecture)
SOURCE_DATE_EPOCH=$(git -C "$root" log -1 --format=%ct)
export SOURCE_DATE_EPOCH CCACHE_DISABLE=1
trees=(1/arbiter another-folder/of-arbiter)
mkdir -p "$work"
exec 9>"$work/lock"
flock -n 9 || fail "artefacts: another run is making them"
# A tree that a stopped run left may be of another commit.
drop_trees
trap drop_trees EXIT

(umask 022; TZ=UTC0 make_turn first "${trees[0]}")
(umask 002; TZ=IST-5:30 make_turn second "${trees[1]}")
step "both turns, compared"
status=0
for part in "${parts[@]}"; do
  printf '%s: ' "$part"
  compare "$work/first/$part" "$work/second/$part" || status=1
done
[[ $status == 0 ]] || fail "artefacts: two builds of one commit are not the same"
rm -rf --one-file-system "$folder"
mkdir -p "$folder"
for part in "${parts[@]}"; do cp "$work/first/$part"/* "$folder/"; done
"$root/scripts/artefacts_list.py" "${whole[@]}" --version "$version" --commit "$commit" \
  --date "$(date -u -d "@$SOURCE_DATE_EPOCH" +%Y-%m-%dT%H:%M:%SZ)" "$folder"
