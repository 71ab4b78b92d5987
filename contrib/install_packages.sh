#!/bin/bash
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# Installs the Debian packages that Waker is built with. Does nothing if none
# is missing.
#
#   contrib/install_packages.sh [--checks] [--cluster]
#
# --checks: those of check.sh, too; --cluster: Slurm, for check.sh --long
set -euo pipefail

packages=(libdeal.ii-dev g++ cmake ninja-build pkg-config lld
  libcli11-dev libeigen3-dev libfftw3-dev librandom123-dev nlohmann-json3-dev zlib1g-dev
  libgtest-dev libbenchmark-dev
  python3-numpy python3-h5py python3-matplotlib python3-meshio)
for argument in "$@"; do
  case "$argument" in
    --checks) packages+=(clang-format-14 python3-xarray python3-h5netcdf) ;;
    --cluster) packages+=(slurm-wlm munge) ;;
    *) echo "usage: $0 [--checks] [--cluster]" >&2; exit 2 ;;
  esac
done

if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
  echo "Not a Debian system. What Debian calls the packages needed:"
  echo "  ${packages[*]}"
  exit 0 # CMake says what is missing
fi

missing=()
for package in "${packages[@]}"; do
  status="$(dpkg-query -W -f '${Status}' "$package" 2>/dev/null || true)"
  [ "$status" = "install ok installed" ] || missing+=("$package")
done
if [ ${#missing[@]} -eq 0 ]; then
  echo "All packages are installed."
  exit 0
fi

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "Missing packages, and neither root nor sudo to install them:" >&2
    echo "  ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi

echo "Installing ${missing[*]}"
# `env`: sudo does not hand variables on.
apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get)
"${apt[@]}" -qq update
"${apt[@]}" -qq -y install --no-install-recommends "${missing[@]}" >/dev/null
echo "Installed."
