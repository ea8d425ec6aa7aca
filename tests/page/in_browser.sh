#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# in_browser.sh FOLDER TEST: one test of the pages or the studio, in Node and, where it wants one, a browser, in a folder that prepare.sh has filled.
# Where it lacks what the test asks for, it is skipped (exit 77).
set -eu
here=$(cd "$(dirname "$0")" && pwd)
cd "$1"
skip() {
  echo "skipped: $1"
  exit 77
}
# Whether the test, or a file beside it that it is made with, names something.
names() {
  grep -q "$1" "$2" && return
  for beside in $(sed -n "s/.* from '\.\/\([^']*\)'.*/\1/p" "$2"); do
    ! grep -q "$1" "$(dirname "$2")/$beside" || return 0
  done
  return 1
}
[ -d node_modules/vite ] || skip "the packages of the studio are not here, test page.build says why"
! names ORISPLINE_STUDIO_WASM "$2" || [ -f "$ORISPLINE_STUDIO_WASM" ] || skip "studio.wasm was not compiled; make studio compiles it"
! names ORISPLINE_STUDIO_PAGE "$2" || [ -f "$ORISPLINE_STUDIO_PAGE" ] || skip "the studio's page was not built; make studio builds it"
if names browser.mjs "$2"; then
  [ -d node_modules/playwright-core ] || skip "the packages of the tests are not here"
  CHROMIUM=$("$here/../chromium.sh") || skip "Chromium is not here and could not be installed"
  export CHROMIUM
fi
[ -f "${ORISPLINE_NPM-}/full.js" ] || unset ORISPLINE_NPM
[ -d "${ORISPLINE_PREFIX-}/include/orispline" ] || unset ORISPLINE_PREFIX
"${ORISPLINE_PYTHON-none}" -c 'import orispline' 2>/dev/null || unset ORISPLINE_PYTHON
exec node --test "$2"
