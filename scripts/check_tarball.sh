#!/usr/bin/env bash
# Uses the folder that runs from anywhere where the machine has none of the libraries that it brings.
# usage: scripts/check_tarball.sh FILE.tar.xz
#
# The machine's own are hidden, by mounts of this process alone. The command and the demonstrations run, and the
# window shows itself without a display and on one; all that the window loads of what was brought is the folder's.
set -euo pipefail

root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
# shellcheck source=scripts/dev_lib.sh
source "$root/scripts/dev_lib.sh"
[[ -f ${1:-} ]] || fail "tarball: no file ${1:-}; ./dev tarball makes one"
file=$(readlink -f "$1")

if [[ -z ${ARBITER_CHECK_INSIDE:-} ]]; then
  as=()
  if [[ $(id -u) != 0 ]]; then as=(--map-root-user); fi
  exec unshare --mount "${as[@]}" --propagation private -- env ARBITER_CHECK_INSIDE=1 "${BASH_SOURCE[0]}" "$file"
fi

work=$(mktemp -d)
end() {
  rm -rf "$work"
  if [[ -n ${display_pid:-} ]]; then kill "$display_pid" 2>/dev/null || true; fi
}
trap end EXIT
plain_environment
unset LD_LIBRARY_PATH QT_PLUGIN_PATH QT_QPA_PLATFORM_PLUGIN_PATH
# A preloaded layer in a folder with a space has a link there.
export HOME=$work/home XDG_RUNTIME_DIR=$work/run
mkdir -p "$HOME" "$work/empty"
mkdir -m 700 "$XDG_RUNTIME_DIR"
# A path that no one has built in, with a space.
mkdir "$work/some where"
tar -C "$work/some where" -xf "$file"
folder=$(echo "$work/some where"/arbiter-*)
mapfile -t brought < <(find "$folder/lib/arbiter-private" -maxdepth 1 -name '*.so*' -printf '%f\n' | sort)
[[ ${#brought[@]} -gt 20 ]] || fail "tarball: the folder brings ${#brought[@]} libraries alone"
step "what the files need"
"$root/scripts/private_libraries.sh" --check "$folder" || fail "tarball: the folder lacks a library"
start_display # before Xvfb's libraries are hidden
trap end EXIT # which start_display has set too

step "the machine's own are hidden"
multiarch=/usr/lib/$(gcc -print-multiarch 2>/dev/null || echo "$(uname -m)-linux-gnu")
# Mesa stands on some of them, and there is no machine without a driver.
drivers='^lib(icu.*|xcb-(randr|render|shape|shm|sync|xfixes))\.so'
hidden=0
for library in "${brought[@]}"; do
  [[ $library =~ $drivers ]] && continue
  for place in "$multiarch" /usr/lib64 /usr/lib; do
    if [[ -e $place/$library ]]; then
      mount --bind /dev/null "$(readlink -f "$place/$library")"
      hidden=$((hidden + 1))
    fi
  done
done
for place in "$multiarch" /usr/lib64 /usr/lib; do
  if [[ -d $place/qt6 ]]; then mount --bind "$work/empty" "$place/qt6"; fi
done
echo "${#brought[@]} are brought, $hidden hidden"

# usage: shown FILE   a PNG of the window, which is large as it has many colours
shown() {
  [[ -s $1 && $(head -c 4 "$1" | tail -c 3) == PNG && $(stat -c %s "$1") -gt 10000 ]] || fail "tarball: no picture in $1"
}

# usage: window PLATFORM   the window makes a picture of itself; says which libraries came from elsewhere
window() {
  local log=$work/libraries.$1
  rm -f "$work/$1.png" "$log".*
  QT_QPA_PLATFORM=$1 LD_DEBUG=files LD_DEBUG_OUTPUT=$log timeout 120 "$folder/bin/arbiter-builder" \
    --screenshot "$work/$1.png" --size 1024x700 gallery:twirl || return 1
  shown "$work/$1.png"
  # Processes that draw load the driver; this is of the window's own.
  grep -l 'calling init: .*/libQt6Widgets' "$log".* | xargs -d '\n' sed -n 's/^ *[0-9]*:\tcalling init: //p' |
    sort -u >"$work/loaded"
  local library elsewhere=0 inside=0 path
  while read -r path; do
    library=${path##*/}
    if [[ $path == "$folder"/* ]]; then
      inside=$((inside + 1))
    elif [[ " ${brought[*]} " == *" $library "* ]] || [[ $library == libQt* || $path == */qt6/* ]]; then
      echo "tarball: $path is not the folder's" >&2
      elsewhere=$((elsewhere + 1))
    fi
  done <"$work/loaded"
  echo "$1: $inside libraries of the folder, $elsewhere of the machine that it brings"
  [[ $elsewhere == 0 && $inside -gt 10 ]]
}

step "the command and a demonstration"
version=${folder##*/arbiter-}
[[ $("$folder/bin/arbiter" --version) == "arbiter ${version%-*}" ]] || fail "tarball: the command is not of $version"
"$folder/bin/arbiter" check gallery:twirl
"$folder/bin/arbiter" draw gallery:twirl -o "$work/twirl.png"
shown "$work/twirl.png"
"$folder/bin/arbiter" run -- "$folder/libexec/arbiter/demos/twirl" --headless --size 64x64
step "the window"
window offscreen || fail "tarball: the window does not start without a display"
window xcb || fail "tarball: the window does not start on a display"
step "without a library of the folder it does not start"
for library in libQt6Gui.so.6 plugins/platforms/libqoffscreen.so; do
  mv "$folder/lib/arbiter-private/$library" "$work/away"
  if window offscreen &>"$work/log"; then fail "tarball: it starts without $library: the machine's is not hidden"; fi
  mv "$work/away" "$folder/lib/arbiter-private/$library"
done
step "licences"
for package in libqt6core6 libqt6gui6 libqt6widgets6 libicu72; do
  grep -q . "$folder/share/doc/arbiter/licences/$package"*.copyright || fail "tarball: no licence of $package"
done
for text in LGPL-3 GPL-3; do [[ -s $folder/share/doc/arbiter/licences/texts/$text ]] || fail "tarball: no text $text"; done
step "tarball: used without the machine's libraries"
