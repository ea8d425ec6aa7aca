#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# prepare.sh SOURCE FOLDER: builds the page of SOURCE (studio/report) in FOLDER with the packages of its lock file.
# Without npm or a Node that is new enough it skips (exit 77).
set -eu
source=$1
folder=$2

command -v npm >/dev/null && node -e '
  const [major, minor] = process.versions.node.split(".").map(Number);
  process.exit(major > 20 || (major === 20 && minor >= 19) ? 0 : 1)' \
  || { echo "page: skipped, npm with Node 20.19 or newer is not here"; exit 77; }

mkdir -p "$folder"
cd "$folder"
rm -rf src tests dist
for part in src tests index.html package.json package-lock.json tsconfig.json vite.config.js; do
  cp -R "$source/$part" .
done
cmp -s package-lock.json node_modules/.installed || {
  npm ci --ignore-scripts --no-audit --no-fund
  cp package-lock.json node_modules/.installed
}
npm run build
