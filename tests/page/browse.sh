#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# browse.sh FOLDER: runs the tests of the viewer and of the page in Chromium, in a folder that prepare.sh has filled. Without the browser
# or the packages it skips (exit 77).
set -eu
here=$(cd "$(dirname "$0")" && pwd)
cd "$1"

[ -d node_modules/playwright-core ] || { echo "page: skipped, its packages are not here"; exit 77; }
CHROMIUM=$("$here/../chromium.sh") || { echo "page: skipped, Chromium is not here and could not be installed"; exit 77; }
export CHROMIUM
exec node --test viewer/tests/*.test.mjs report/tests/*.test.mjs
