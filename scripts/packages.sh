# shellcheck shell=bash disable=SC2034  # the arrays are read by ./dev
# Debian's packages by what needs them; docs/design/dependencies.md says why each is here. NAME|OTHER is what one
# release of Debian calls differently from another: the first that is installed or can be.

# The layer, the command and the demonstrations: what compiles, and the software GL they run on.
packages_build=(
  g++ meson ninja-build ccache pkg-config python3
  libgl-dev libegl-dev libopengl-dev libglvnd-dev libglvnd-core-dev libx11-dev libxext-dev
  khronos-api libosmesa6-dev libepoxy-dev libglm-dev libglfw3-dev libpng-dev
  libjpeg62-turbo-dev libtinyobjloader-dev
  'llvm-15-dev|llvm-19-dev' libzstd-dev libfmt-dev libxxhash-dev nlohmann-json3-dev libtomlplusplus-dev libelf-dev libcli11-dev
  qt6-base-dev qt6-base-dev-tools
  libgl1 libglx0 libegl1 libopengl0 libgl1-mesa-dri libegl-mesa0 libglx-mesa0 libosmesa6
)

# `./dev test`: unit tests, the clients, piglit and a display for them, a browser for pages.
packages_test=(
  libgtest-dev libgmock-dev lld glslang-tools xvfb xauth piglit
  libsdl2-dev libglew-dev chromium xdotool appstream desktop-file-utils shared-mime-info libglib2.0-bin python3-yaml vim neovim emacs-nox nodejs zsh fish man-db parallel rsync libjemalloc2 'libtcmalloc-minimal4|libtcmalloc-minimal4t64' locales valgrind
)

# The real programs of `./dev test`: openscad, and recordings of clients in Python.
packages_real_quick=(openscad apitrace python3-opengl freeglut3-dev)

# `./dev real` asks tests/real_programs_vs_host/run.py --packages, which knows what each of its programs needs.

# Shards of a suite on several machines: `./dev piglit --engine parallel`, and `--engine slurm`.
packages_parallel=(parallel rsync openssh-client)
packages_slurm=(slurm-client)

# `./dev hosts zink`: llvmpipe's Vulkan driver, among others.
packages_zink=(mesa-vulkan-drivers)

packages_bench=(xvfb xauth)
packages_check_quick=(clang-format flake8 shellcheck)
packages_check=(clang-tidy reuse)
packages_clang=(clang)
packages_fuzz=(clang-14 libclang-rt-14-dev)
packages_package=(dpkg-dev debhelper fakeroot ccache)
# mmdebstrap asks arch-test whether programs of a second architecture run here.
packages_package_chroot=(mmdebstrap arch-test)
packages_package_check=(lintian g++-mingw-w64-x86-64 g++-mingw-w64-i686)
packages_docs=(mkdocs chromium)
packages_pictures=(libwildmagic-examples ffmpeg xvfb python3-pil fonts-dejavu-core)
packages_tarball=(patchelf xz-utils binutils)
packages_tarball_check=(xvfb)
packages_artefacts=(python3 xz-utils)
packages_flatpak=(flatpak flatpak-builder git)
packages_arm64=(g++-aarch64-linux-gnu qemu-user)
# arch-test says whether programs of 32 bits run here; qemu runs them where they do not.
packages_i386=(g++-i686-linux-gnu patchelf arch-test qemu-user)
