#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# build.sh WORK PACKAGE: the npm package in the folder PACKAGE, ready for `npm pack`, by the tools of the lock file in WORK. Skips as
# tests/npm_ci.sh does (exit 77).
set -eu
source=$(cd "$(dirname "$0")" && pwd)
root=$source/../..
work=$1
package=$2

"$root/tests/npm_ci.sh" "$source" "$work"
rm -rf "$work/src" "$package"
mkdir -p "$package"
cp -R "$source/src" "$source/tsconfig.json" "$work"
"$work/node_modules/.bin/tsc" --project "$work" --outDir "$package"
cp "$source/README.md" "$root/LICENSE" "$root/NOTICE" "$root/THIRD_PARTY" "$package"
node -e '
  const { readFileSync, writeFileSync } = require("node:fs");
  const { devDependencies, scripts, ...kept } = JSON.parse(readFileSync(process.argv[1]));
  writeFileSync(process.argv[2], JSON.stringify(kept, null, 2) + "\n");' "$source/package.json" "$package/package.json"
