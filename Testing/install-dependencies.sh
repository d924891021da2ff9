#!/bin/bash
# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Installs what the project is built and tested with on Debian 12, if it is missing.

as_root()
{
  if [ "$(id -u)" -ne 0 ]; then
    sudo "$@"
  else
    "$@"
  fi
}

# Those of the packages that are not installed, in `missing`.
find_missing()
{
  missing=()
  local package
  for package in "$@"; do
    if [ "$(dpkg-query -W -f='${Status}' "$package" 2> /dev/null)" != "install ok installed" ]; then
      missing+=("$package")
    fi
  done
}

# Says what is going to be installed, and how much that is with all that it needs.
announce_packages()
{
  find_missing "$@"
  if [ ${#missing[@]} -gt 0 ]; then
    echo "-- Installing ${missing[*]}"
    as_root apt-get -qq update
    LC_ALL=C apt-get install --no-install-recommends --assume-no "${missing[@]}" 2> /dev/null \
      | sed -n 's/^\(Need to get\|After this\)/   &/p' || true
  fi
}

# Files go to the disk once, at the end, and not one by one: half of the time would be waiting.
install_announced()
{
  find_missing "$@"
  if [ ${#missing[@]} -gt 0 ]; then
    as_root env DEBIAN_FRONTEND=noninteractive apt-get -qq install -y --no-install-recommends \
      -o Dpkg::Use-Pty=0 -o Dpkg::Options::=--force-unsafe-io "${missing[@]}" > /dev/null
    sync
  fi
}

install_packages()
{
  announce_packages "$@"
  install_announced "$@"
}

# Compiler, CMake, GoogleTest, ParaView with its development files and the library that draws its icons,
# and what Python reads DICOM files with; and the packages given.
dependencies=(g++ cmake ninja-build python3-dev libgtest-dev libcgal-dev libeigen3-dev libopenmpi-dev
  openmpi-bin paraview paraview-dev python3-paraview libtbb-dev libglew-dev libfreetype-dev libqt5svg5
  xvfb xauth python3-numpy python3-pydicom python3-gdcm)
install_dependencies()
{
  install_packages "${dependencies[@]}" "$@"
}

# What the core is built with and looked at by clang-tidy.
install_tidy()
{
  install_packages g++ cmake ninja-build libeigen3-dev clang-tidy
}

# What the core is built and tested with, and gcovr.
install_coverage()
{
  install_packages g++ cmake ninja-build python3 libeigen3-dev libgtest-dev libcgal-dev gcovr
}

# Plain VTK in the folder $1. Debian refuses to install it beside ParaView's Python, so its packages
# are unpacked there.
unpack_vtk()
{
  local prefix=$1
  if [ -e "$prefix/complete" ]; then
    return 0
  fi

  echo "-- Unpacking plain VTK into $prefix"
  rm -rf "$prefix"
  mkdir -p "$prefix/packages"
  (
    cd "$prefix/packages"
    download="apt-get -qq -o APT::Sandbox::User=root download libvtk9-dev libvtk9.1 python3-vtk9 vtk9"
    $download 2> /dev/null || { apt-get -qq update && $download; }
    for package in *.deb; do
      dpkg -x "$package" "$prefix"
    done
  )
  rm -rf "$prefix/packages"
  touch "$prefix/complete"
}
