#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Formats the C++ sources in place; with --check it only says what differs. Without clang-format 14 it skips (exit 77).
set -eu
cd "$(dirname "$0")/.."

for formatter in clang-format-14 clang-format none; do
  if "$formatter" --version 2>/dev/null | grep -q 'version 14\.'; then break; fi
done
[ "$formatter" != none ] || { echo "format: skipped, clang-format 14 is not here (other versions format differently)"; exit 77; }

case ${1:-} in
  --check) mode='--dry-run -Werror' ;;
  '') mode=-i ;;
  *) echo "usage: tools/format.sh [--check]" >&2; exit 2 ;;
esac
find src cli papers bindings tests examples benchmarks \( -name '*.hpp' -o -name '*.cpp' \) -print0 | xargs -0 "$formatter" $mode
