#!/bin/bash
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# Configures and builds in build/. quickstart.sh and check.sh share it, with the
# same compiler flags, so that neither compiles again what the other has.
#
#   contrib/build.sh [-DOPTION=VALUE ...] [TARGET ...]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

options=(-DCMAKE_BUILD_TYPE=Release -DWAKER_NATIVE=ON)
# The code is free of warnings with the compiler of Debian 12. Another one may
# know more of them, which must not keep anyone from building.
if [ "$(g++ -dumpversion)" = 12 ]; then
  options+=(-DWAKER_WERROR=ON)
fi
targets=()
for argument in "$@"; do
  case "$argument" in
    -D*) options+=("$argument") ;;
    *) targets+=("$argument") ;;
  esac
done

# Compiling a file that uses much of deal.II takes up to 1.2 GB.
memory="$(awk '/^MemAvailable/ {print int($2 / 1024)}' /proc/meminfo)"
limit="$(cat /sys/fs/cgroup/memory.max 2>/dev/null || true)"
if [[ "$limit" =~ ^[0-9]+$ ]] && [ $((limit / 1048576)) -lt "$memory" ]; then
  memory=$((limit / 1048576))
fi
jobs=$((memory / 1200))
[ "$jobs" -le "$(nproc)" ] || jobs="$(nproc)"
[ "$jobs" -ge 1 ] || jobs=1

echo "Configuring build/ (${options[*]})"
mkdir -p build
cmake -S . -B build -G Ninja "${options[@]}" >build/configure.log 2>&1 || {
  cat build/configure.log >&2
  exit 1
}
echo "Building ${targets[*]:-everything} with $jobs jobs"
cmake --build build -j "$jobs" ${targets[@]:+--target "${targets[@]}"}
