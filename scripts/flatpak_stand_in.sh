#!/usr/bin/env bash
# A Debian 13 under the names of freedesktop's runtime, SDK and GL driver, for `./dev flatpak` where Flathub is out of
# reach. It has their extension points, and the SDK's flags of the compiler. Runs as root.
# usage: scripts/flatpak_stand_in.sh FOLDER [BRANCH]     24.08 without. FOLDER/installation is the installation,
#                                                        if FLATPAK_USER_DIR names it: yours is left alone
set -euo pipefail

root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
# shellcheck source=scripts/dev_lib.sh
source "$root/scripts/dev_lib.sh"
mkdir -p "$1"
folder=$(readlink -f "$1")
branch=${2:-24.08}
export FLATPAK_USER_DIR=$folder/installation
libraries=lib/x86_64-linux-gnu
platform=org.freedesktop.Platform
sdk=org.freedesktop.Sdk
example=org.example.Gears
runs=bash,ca-certificates,libgl1,libglx0,libegl1,libopengl0,libgles2,libgl1-mesa-dri,libegl-mesa0,libglx-mesa0,libx11-6
runs+=,libxext6,libpng16-16t64,libjpeg62-turbo,libepoxy0,libelf1t64,zlib1g,libzstd1,libtinfo6,libstdc++6,mesa-utils-bin
builds=$runs,g++,ccache,meson,ninja-build,pkgconf,python3,xz-utils,libgl-dev,libegl-dev
builds+=,libopengl-dev,libglvnd-dev,libglvnd-core-dev,libx11-dev,libxext-dev,libpng-dev,libjpeg62-turbo-dev
builds+=,libepoxy-dev,libelf-dev,zlib1g-dev,libzstd-dev,libxxhash-dev,libncurses-dev

# usage: debian NAME PACKAGES     FOLDER/NAME.root, which is kept
debian() {
  if [[ -d $folder/$1.root ]]; then return; fi
  step "a Debian 13 for $1"
  mmdebstrap --quiet --variant=essential --mode=root --aptopt='APT::Install-Recommends "false"' \
    --dpkgopt='path-exclude=/usr/share/man/*' --dpkgopt='path-exclude=/usr/share/doc/*' \
    --dpkgopt='path-exclude=/usr/share/locale/*' --include="$2" trixie "$folder/$1.part" \
    "deb http://deb.debian.org/debian trixie main"
  mv "$folder/$1.part" "$folder/$1.root"
}

# usage: runtime NAME     FOLDER/NAME from the Debian, without the driver, with freedesktop-sdk's extension points
runtime() {
  local tree=$folder/$1
  rm -rf --one-file-system "$tree"
  mkdir -p "$tree/files"
  cp -a "$folder/$1.root/usr" "$tree/usr"
  cp -a "$folder/$1.root/etc" "$tree/usr/etc"
  rm -f "$tree"/usr/etc/{ld.so.cache,machine-id,resolv.conf,hostname,passwd-,mtab} "$tree"/usr/etc/{,g}shadow*
  mkdir -p "$tree/usr/lib/extensions/vulkan" "$tree/usr/$libraries/GL" "$tree/driver/lib" "$tree/driver/glvnd"
  ln -sf ../sbin/ldconfig "$tree/usr/bin/ldconfig"
  printf 'include /run/flatpak/ld.so.conf.d/%s-*.conf\n' app runtime >"$tree/usr/etc/ld.so.conf"
  mv "$tree/usr/$libraries"/{lib{GLX,EGL}_mesa.so*,libgallium-*,libLLVM*,libgbm.so*,gbm,dri} "$tree/driver/lib/"
  mv "$tree/usr/share/glvnd/egl_vendor.d" "$tree/driver/glvnd/"
  rmdir "$tree/usr/share/glvnd"
  ln -s "../$libraries/GL/glvnd" "$tree/usr/share/glvnd"
  cat >"$tree/metadata" <<TEXT
[Runtime]
name=$1
runtime=$platform/x86_64/$branch
sdk=$sdk/x86_64/$branch

[Extension $platform.GL]
version=$branch
directory=$libraries/GL
subdirectories=true
no-autodownload=true
add-ld-path=lib
merge-dirs=glvnd/egl_vendor.d;lib/dri;lib/gbm
enable-if=active-gl-driver

[Extension $platform.VulkanLayer]
version=$branch
directory=lib/extensions/vulkan
subdirectories=true
no-autodownload=true
merge-dirs=share/vulkan/implicit_layer.d;share/vulkan/explicit_layer.d;
TEXT
}

# usage: give TREE FILES     exports TREE as its metadata calls it; the files lie in TREE/FILES
give() { flatpak build-export --disable-sandbox --runtime --files="$2" "$folder/repo" "$1" "$branch" >/dev/null; }

debian $platform "$runs"
debian $sdk "$builds"
step "exporting, installing into $FLATPAK_USER_DIR"
rm -rf --one-file-system "$folder/repo"
ostree init --repo="$folder/repo" --mode=bare-user-only
runtime $platform
runtime $sdk
flags="-O2 -pipe -g -Wp,-D_FORTIFY_SOURCE=3 -Wp,-D_GLIBCXX_ASSERTIONS -fexceptions -fstack-protector-strong"
flags+=" -grecord-gcc-switches -fasynchronous-unwind-tables -fstack-clash-protection -fcf-protection"
flags+=" -fno-omit-frame-pointer -mno-omit-leaf-frame-pointer"
mkdir "$folder/$sdk/usr/etc/flatpak-builder"
printf '{"cflags": "%s", "cxxflags": "%s", "ldflags": "-L/app/lib -Wl,-z,relro,-z,now -Wl,--as-needed"}\n' \
  "$flags" "$flags" >"$folder/$sdk/usr/etc/flatpak-builder/defaults.json"
give "$folder/$platform" usr
give "$folder/$sdk" usr
printf '[Runtime]\nname=%s\n\n[ExtensionOf]\nref=runtime/%s/x86_64/%s\n' $platform.GL.default $platform "$branch" \
  >"$folder/$platform/metadata"
give "$folder/$platform" driver
flatpak remote-add --user --if-not-exists --no-gpg-verify stand-in "$folder/repo"
flatpak install --user -y --noninteractive stand-in $platform//"$branch" $platform.GL.default//"$branch" $sdk//"$branch"
rm -rf "${folder:?}/$example"
flatpak build-init "$folder/$example" $example $sdk $platform "$branch"
flatpak build-finish "$folder/$example" --socket=x11 --share=ipc --device=dri --command=glxgears.x86_64-linux-gnu
flatpak build-export "$folder/repo" "$folder/$example" "$branch" >/dev/null
flatpak install --user -y --noninteractive stand-in $example//"$branch"
