#!/bin/bash
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# What must be good before a change goes in: builds everything with warnings as
# errors, checks the format of the code, runs the tests.
#
#   contrib/check.sh [--long]      --long: also the tests labelled "long"
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

tests=(-LE long)
packages=(--checks)
for argument in "$@"; do
  case "$argument" in
    --long) tests=(); packages=(--checks --cluster) ;;
    *) echo "usage: $0 [--long]" >&2; exit 2 ;;
  esac
done

echo "== 1. Packages"
contrib/install_packages.sh "${packages[@]}"

echo "== 2. Format"
if git rev-parse --is-inside-work-tree >/dev/null 2>&1; then
  list=(git ls-files -z -- '*.h' '*.cc')
else
  list=(find . -path './build*' -prune -o -name '*.h' -print0
    -o -name '*.cc' -print0)
fi
"${list[@]}" | xargs -0 -r clang-format-14 --dry-run --Werror
echo "The code is formatted."

echo "== 3. Build"
options=(-DWAKER_WERROR=ON -DWAKER_TESTS=ON)
if [ -f benchmarks/CMakeLists.txt ]; then
  options+=(-DWAKER_BENCHMARKS=ON)
fi
contrib/build.sh "${options[@]}"

echo "== 4. Tests"
# Open MPI refuses root and more ranks than cores unless told so.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export OMPI_MCA_rmaps_base_oversubscribe=1
cd build
ctest --output-on-failure --no-tests=error -j2 ${tests[@]:+"${tests[@]}"}
