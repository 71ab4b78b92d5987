#!/bin/bash
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# Installs a build of Waker to a temporary folder, builds the project beside
# this script against it, and runs that.
#
#   tests/consumer/test.sh BUILD_DIR
set -euo pipefail

if [ $# -ne 1 ] || [ ! -f "$1/CMakeCache.txt" ]; then
  echo "usage: $0 BUILD_DIR (of a finished build)" >&2
  exit 2
fi
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
scratch="$(mktemp -d)"
trap 'rm -rf "$scratch"' EXIT

cmake --install "$1" --prefix "$scratch/prefix" >/dev/null
test -x "$scratch/prefix/bin/waker"
# A header that asks for one that is not installed shows here, not at a user's:
# the source tree is not on any path.
cmake -S "$here" -B "$scratch/build" -G Ninja \
  -DCMAKE_PREFIX_PATH="$scratch/prefix"
cmake --build "$scratch/build"
cd "$scratch" # for the files that it writes
build/consumer
