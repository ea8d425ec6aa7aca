#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# run.sh PACKAGE TEST: one test of the npm package that bindings/npm/build.sh has made in PACKAGE, or skips where it could not (exit 77).
set -eu
here=$(cd "$(dirname "$0")" && pwd)
[ -f "$1/package.json" ] || { echo "skipped: the npm package was not built, test npm.build says why"; exit 77; }
[ "$2" = consume ] || exec node --test "$here/$2.test.mjs"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
(cd "$1" && npm pack --silent --pack-destination "$folder" >/dev/null)
"$here/consume.sh" "$folder"/orispline-*.tgz
