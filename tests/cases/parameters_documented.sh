#!/bin/bash
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# Is doc/parameters.md what the program prints?
#
#   tests/cases/parameters_documented.sh WAKER SOURCE_DIR
set -euo pipefail

if [ $# -ne 2 ]; then
  echo "usage: $0 WAKER SOURCE_DIR" >&2
  exit 2
fi
page="$2/doc/parameters.md"
printed="$(mktemp)"
trap 'rm -f "$printed"' EXIT

"$1" parameters --format markdown >"$printed"
# A program that prints nothing would agree with an empty page.
if ! grep -q '^| Cell size |' "$printed"; then
  echo "waker parameters --format markdown does not list the parameters" >&2
  exit 1
fi
if ! diff -u "$page" "$printed"; then
  echo "doc/parameters.md is out of date. Write it again:" >&2
  echo "  build/bin/waker parameters --format markdown > doc/parameters.md" >&2
  exit 1
fi
