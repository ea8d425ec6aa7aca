#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# run.sh PACKAGE TEST: one test of the npm package that bindings/npm/build.sh has made in PACKAGE. It is skipped (exit 77) where that could not be made, or
# has no module that the test needs.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
skip() {
  echo "skipped: $1"
  exit 77
}
[ -f "$1/package.json" ] || skip "the npm package was not built, test npm.build says why"
case $2 in
  package | player | mutated) ;;
  browser)
    [ -f "$1/full.wasm" ] || skip "the modules were not compiled; make web compiles them"
    CHROMIUM=$("$here/../chromium.sh") || skip "Chromium is not here"
    export CHROMIUM
    ;;
  arguments) [ -f "$1/full.wasm" ] || skip "the modules were not compiled; make web compiles them" ;;
  consume | three) [ -f "$1/lite.wasm" ] || skip "the modules were not compiled; make web compiles them" ;;
  *) [ -f "$1/$2.wasm" ] || skip "the module $2.wasm was not compiled; make web compiles it" ;;
esac
[ "$2" = consume ] || exec node --test "$here/$2.test.mjs"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
(cd "$1" && npm pack --silent --pack-destination "$folder" >/dev/null)
exec python3 "$here/../shown/scripts_test.py" "$folder"/orispline-*.tgz
