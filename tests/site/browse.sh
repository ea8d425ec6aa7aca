#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# browse.sh SITE FOLDER: uses the site in Chromium, with the packages that FOLDER gets. Says so where it skips what is not here.
set -eu
site=$1
folder=$2
here=$(cd "$(dirname "$0")" && pwd)

skip() {
  echo "site: skipped: $1"
  exit 0
}

[ -f "$site/index.html" ] || skip "there is no site to test"
packages=$("$here/../npm_ci.sh" "$here/../../studio" "$(mkdir -p "$folder" && cd "$folder" && pwd)") || {
  [ $? -eq 77 ] && skip "${packages#skipped: }"
  exit 1
}
CHROMIUM=$("$here/../chromium.sh") || skip "Chromium is not here and could not be installed"
export CHROMIUM
cp "$here/site.test.mjs" "$here/../../studio/report/tests/browser.mjs" "$folder"
SITE=$(cd "$site" && pwd) exec node --test "$folder/site.test.mjs"
