#!/usr/bin/env bash
# Puts the shared libraries that programs need, and that a desktop may lack, into the folder that the programs are
# in, with the licences of all that comes from others.
# usage: scripts/private_libraries.sh FOLDER PROGRAM...
#        scripts/private_libraries.sh --check FOLDER     1 if a file there needs what is neither there nor of a desktop
#
# FOLDER/lib/arbiter-private has the libraries, and the plug-ins of Qt where a program needs it; FOLDER/bin/qt.conf
# leads Qt there. They are Debian's files, to the byte. FOLDER/share/doc/arbiter/licences has Debian's statements
# of copyright, and the texts that these refer to. Who wants another Qt puts its files in the place of these.
set -euo pipefail

root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
# shellcheck source=scripts/dev_lib.sh
source "$root/scripts/dev_lib.sh"
check=false
if [[ ${1:-} == --check ]]; then
  check=true
  shift
fi
folder=$1
shift
private=$folder/lib/arbiter-private
licences=$folder/share/doc/arbiter/licences

# Each desktop has these, and some of them must be its own: the compiler's and the C library, what the driver
# of GL (libelf) and the connection to the X server are, fonts, D-Bus, GLib. What they need is theirs.
base='^(ld-linux.*|lib(c|m|dl|rt|pthread|resolv|util|gcc_s|stdc\+\+|GL|EGL|GLX|OpenGL|GLdispatch|OSMesa|X11|X11-xcb|'
base+='Xext|xcb|Xau|Xdmcp|ICE|SM|fontconfig|freetype|harfbuzz|expat|z|zstd|glib-2\.0|dbus-1|elf|tinfo))\.so(\.|$)'
# Compiled into programs and libraries, of headers or archives; a machine that builds has one LLVM of these.
compiled_in=(libcli11-dev libfmt-dev libglm-dev libtomlplusplus-dev libxxhash-dev nlohmann-json3-dev libzstd-dev
  'llvm-15-dev|llvm-19-dev')
plugins=(platforms/libqxcb.so platforms/libqoffscreen.so platforminputcontexts/libcomposeplatforminputcontextplugin.so)

declare -A path_of=() packages=()

needed() { objdump -p "$1" | awk '$1 == "NEEDED" { print $2 }'; }

# Names what is needed and lacking. usage: lacking
lacking() {
  local file name status=0 files=0
  while read -r file; do
    [[ $(head -c 4 "$file" | tail -c 3) == ELF ]] || continue
    files=$((files + 1))
    while read -r name; do
      # The folder's own libraries lie beside each other.
      if [[ ! $name =~ $base && ! -e $private/$name && ! -e ${file%/*}/$name ]]; then
        echo "tarball: ${file#"$folder"/} needs $name" >&2
        status=1
      fi
    done < <(needed "$file")
  # The front of OSMesa names the real one by its path, and is used where that is installed.
  done < <(find "$folder"/{bin,lib,libexec} -type f ! -path '*/arbiter/osmesa/*')
  echo "$files programs and libraries read"
  [[ $files != 0 ]] && return "$status"
}

# usage: note_package FILE   the package of a library that is taken is one whose licence is kept
note_package() {
  local file owner
  file=$(readlink -f "$1")
  # Where /lib is a link to /usr/lib, packages may name either.
  owner=$(dpkg-query -S "$file" "${file#/usr}" 2>/dev/null | head -1) || true
  [[ -n $owner ]] || fail "tarball: $file belongs to no package, so that its licence is not known"
  packages[${owner%%:*}]=1
}

# usage: take FILE...   copies what the files need, and what that needs; not what is the base's
take() {
  local -a queue=("$@")
  local name path
  while read -r name path; do path_of[$name]=$path; done < <(
    for path in "$@"; do ldd "$path"; done | awk '$2 == "=>" && $3 ~ "^/" { print $1, $3 }')
  while [[ ${#queue[@]} -gt 0 ]]; do
    while read -r name; do
      [[ $name =~ $base || -e $private/$name ]] && continue
      [[ -n ${path_of[$name]:-} ]] || fail "tarball: $name is not on this machine"
      install -m 644 "${path_of[$name]}" "$private/$name"
      note_package "${path_of[$name]}"
      queue+=("${path_of[$name]}")
    done < <(needed "${queue[0]}")
    queue=("${queue[@]:1}")
  done
}

take_plugins() {
  local folder_of_qt plugin
  folder_of_qt=$(dirname "$(readlink -f "${path_of[libQt6Core.so.6]}")")/qt6/plugins
  for plugin in "${plugins[@]}"; do
    [[ -f $folder_of_qt/$plugin ]] || fail "tarball: $folder_of_qt has no $plugin"
    install -Dm 644 "$folder_of_qt/$plugin" "$private/plugins/$plugin"
    note_package "$folder_of_qt/$plugin"
    take "$folder_of_qt/$plugin"
  done
  # Relative to the folder of the program.
  printf '[Paths]\nPrefix = ../lib/arbiter-private\nPlugins = plugins\n' >"$folder/bin/qt.conf"
}

keep_licences() {
  local package text
  mkdir -p "$licences/texts"
  for package in "${compiled_in[@]}"; do
    for text in ${package//|/ }; do
      if is_installed "$text"; then packages[$text]=1; fi
    done
  done
  for package in "${!packages[@]}"; do
    install -m 644 "/usr/share/doc/$package/copyright" "$licences/$package.copyright"
  done
  # A statement names a text of Debian's common ones by its path; the LGPL's third version is added to the GPL's.
  { grep -rhoE '/usr/share/common-licenses/[A-Za-z0-9.-]*[A-Za-z0-9]' "$licences" || true
    echo /usr/share/common-licenses/{LGPL,GPL}-3; } | sort -u |
    while read -r text; do
      if [[ -f $text ]]; then install -m 644 "$text" "$licences/texts/${text##*/}"; fi
    done
}

if $check; then
  lacking
  exit
fi
mkdir -p "$private"
take "$@"
if [[ -e $private/libQt6Gui.so.6 ]]; then take_plugins; fi
keep_licences
for program in "$@"; do
  # The path of a program with Qt serves its libraries and plug-ins too, so that they stay as Debian made them. The
  # others load a driver, which takes nothing from here.
  forced=()
  if objdump -p "$program" | grep -q 'NEEDED.*libQt6'; then forced=(--force-rpath); fi
  patchelf "${forced[@]}" --set-rpath "\$ORIGIN/$(realpath --relative-to="$(dirname "$program")" "$private")" "$program"
done
