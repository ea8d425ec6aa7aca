#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# compare.sh BUILT EMBEDDED: whether a page or module that is kept is the one that its sources give.
set -eu
[ -f "$1" ] || { echo "page: skipped, it could not be built here"; exit 77; }
cmp "$1" "$2" || { echo "page: $2 is not what studio gives; run 'make page'" >&2; exit 1; }
