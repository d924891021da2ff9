#!/bin/bash
# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Configures build folders. What CMake says is shown if it fails; it is in FOLDER.log.

configure_options=() # of all folders

# configure FOLDER OPTION...
configure()
{
  local folder=$1
  shift
  echo "-- Configuring $folder"
  if ! cmake -DPython3_EXECUTABLE=/usr/bin/python3 -Wno-dev "${configure_options[@]}" "$@" \
    > "$folder.log" 2>&1; then
    cat "$folder.log"
    return 1
  fi
}

configure_folder()
{
  local folder=$1
  shift
  configure "$folder" -G Ninja -S . -B "$folder" "$@"
}
