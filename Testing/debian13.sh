#!/bin/bash
# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# bash Testing/debian13.sh
# Passes the tests of core, filter and plugin on Debian 13 (ParaView 5.13, VTK 9.3, Qt 6), as
# Testing/test.sh does on Debian 12: in a root of its own, build/debian13 or what ORTHOGONAL_SLICES_ROOT
# says, which debootstrap makes the first time (2.5 GB). Takes root's rights, asked for by sudo, and
# Debian's archive. DEBIAN_MIRROR is another place of that than
# deb.debian.org, ORTHOGONAL_SLICES_JOBS another number of jobs than there are processors.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source Testing/install-dependencies.sh

root=${ORTHOGONAL_SLICES_ROOT:-$PWD/build/debian13}
jobs=${ORTHOGONAL_SLICES_JOBS:-$(nproc)}
mirror=${DEBIAN_MIRROR:-http://deb.debian.org/debian}
sudo=
if [ "$(id -u)" -ne 0 ]; then
  sudo=sudo
fi

# Runs a script in the root. What is mounted for it is gone with it.
in_root()
{
  $sudo unshare --mount --propagation private bash -c '
    for folder in dev sys; do
      mount --rbind "/$folder" "$0/$folder"
    done
    mount -t proc proc "$0/proc"
    exec chroot "$0" env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 \
      DEBIAN_FRONTEND=noninteractive bash -ec "$1"' "$root" "$1"
}

# Debian's paraview-dev 5.13.2 names the modules of Python without the tag of the interpreter that their
# files have, and CMake does not find ParaView for it.
link_modules='
for file in $(find /usr/lib/python3/dist-packages/vtkmodules /usr/lib/python3/dist-packages/paraview \
    -name "*.cpython-*.so"); do
  ln -sf "$file" "${file%%.cpython-*}.so"
done'

make_root()
{
  if [ -e "$root/complete" ]; then
    return 0
  fi
  install_packages debootstrap
  echo "-- Making a Debian 13 in $root"
  mkdir -p "$root"
  $sudo debootstrap --variant=minbase trixie "$root" "$mirror" > "$root.log" 2>&1
  $sudo cp /etc/resolv.conf "$root/etc/resolv.conf"
  in_root "apt-get -qq update
    apt-get -qq install -y --no-install-recommends -o Dpkg::Use-Pty=0 g++ cmake ninja-build python3-dev \
      libgtest-dev libcgal-dev libeigen3-dev libopenmpi-dev openmpi-bin paraview paraview-dev \
      python3-paraview libtbb-dev libglew-dev libfreetype-dev libqt6sql6-sqlite qt6-svg-plugins qt6-tools-dev \
      xvfb xauth python3-numpy python3-pydicom python3-gdcm dpkg-dev file > /dev/null
    $link_modules
    touch /complete"
}

copy_sources()
{
  $sudo mkdir -p "$root/source"
  git ls-files -z | tar --null -T - -cf - | $sudo tar -C "$root/source" -xf -
}

make_root
copy_sources
in_root "cd /source
  options='-G Ninja -S . -DCMAKE_COMPILE_WARNING_AS_ERROR=ON -Wno-dev'
  cmake \$options -B build/core -DORTHOGONAL_SLICES_CORE_ONLY=ON > build-core.log
  cmake \$options -B build/paraview -DORTHOGONAL_SLICES_CORE_BUILD=\$PWD/build/core \
    -DORTHOGONAL_SLICES_TEST_PREFIX=paraview. -DORTHOGONAL_SLICES_TEST_INTERFACE_ONLY=ON \
    -DCMAKE_INSTALL_PREFIX=/usr > build-paraview.log
  for folder in core paraview; do
    echo \"-- Building build/\$folder in $root/source\"
    ninja -C build/\$folder -j $jobs
  done
  printf 'subdirs(\"%s\")\n' core paraview > build/CTestTestfile.cmake
  ctest --test-dir build -j $jobs --output-on-failure"
