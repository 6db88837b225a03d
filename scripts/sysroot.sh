# shellcheck shell=bash
# Debian's packages of another architecture, unpacked into a folder: what a cross build finds its
# headers and libraries in. Nothing of the running system is changed.

# usage: unpack_sysroot ARCHITECTURE TREE PACKAGE...     into TREE/root, once for the same packages
#
# A package manager of its own knows the system's archives and believes that nothing is installed.
unpack_sysroot() {
  local architecture=$1 tree=$2 package
  shift 2
  local apt=$tree/apt
  if [[ -f $tree/unpacked && $(<"$tree/unpacked") == "$*" ]]; then return; fi
  rm -rf "$tree/root" "$apt"
  mkdir -p "$apt"/{state/lists/partial,cache/archives/partial,etc} "$tree/root"
  cp -r /etc/apt/. "$apt/etc"
  : >"$apt/status"
  cat >"$apt/apt.conf" <<TEXT
APT::Architecture "$architecture";
APT::Architectures { "$architecture"; };
APT::Install-Recommends "false";
APT::Sandbox::User "root";
Debug::NoLocking "true";
Dir::State "$apt/state";
Dir::State::status "$apt/status";
Dir::Cache "$apt/cache";
Dir::Etc "$apt/etc";
TEXT
  # An archive that has nothing for the architecture, or does not answer, is missed where a package is.
  APT_CONFIG=$apt/apt.conf apt-get update -qq || true
  APT_CONFIG=$apt/apt.conf apt-get install -y -qq --download-only "$@"
  for package in "$apt"/cache/archives/*.deb; do dpkg-deb -x "$package" "$tree/root"; done
  rm -rf "$apt/cache"
  # Links to absolute paths mean the unpacked files.
  local link
  while IFS= read -r link; do
    ln -sfn "$tree/root$(readlink "$link")" "$link"
  done < <(find "$tree/root" -type l -lname '/*')
  printf '%s' "$*" >"$tree/unpacked"
}

# usage: write_pkg_config TREE TRIPLET     TREE/pkg-config, which knows the unpacked packages alone
write_pkg_config() {
  cat >"$1/pkg-config" <<TEXT
#!/bin/sh
export PKG_CONFIG_SYSROOT_DIR=$1/root
export PKG_CONFIG_LIBDIR=$1/root/usr/lib/$2/pkgconfig:$1/root/usr/share/pkgconfig
exec pkg-config "\$@"
TEXT
  chmod +x "$1/pkg-config"
}

# usage: write_llvm_config TREE COMPONENT     TREE/llvm-config-15, of the unpacked LLVM, for programs
# of that target; the names of the libraries are the same as this machine's
write_llvm_config() {
  cat >"$1/llvm-config-15" <<TEXT
#!/bin/sh
case "\$1" in
  --version) echo 15.0.6 ;;
  --includedir) echo $1/root/usr/lib/llvm-15/include ;;
  --libdir) echo $1/root/usr/lib/llvm-15/lib ;;
  --link-shared) echo -lLLVM-15 ;;
  --link-static) [ "\$2" = --system-libs ] || exec llvm-config-15 --link-static --libs $2 runtimedyld passes ;;
esac
TEXT
  chmod +x "$1/llvm-config-15"
}

# usage: write_cross_file TREE PREFIX FAMILY CPU [LINE]     TREE/cross.ini, of the cross compiler PREFIX-g++
# and of what is written above; LINE is one more of its [binaries]. Options are the caller's to append.
write_cross_file() {
  cat >"$1/cross.ini" <<TEXT
[host_machine]
system = 'linux'
cpu_family = '$3'
cpu = '$4'
endian = 'little'

[binaries]
cpp = ['ccache', '$2-g++']
ar = '$2-ar'
strip = '$2-strip'
pkgconfig = '$1/pkg-config'
llvm-config-15 = '$1/llvm-config-15'
${5-}
TEXT
}
