#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# prepare.sh SOURCE FOLDER: builds the page of SOURCE (studio) in FOLDER/report/dist with the packages of its lock file, or skips
# as npm_ci.sh does (exit 77).
set -eu
source=$1
folder=$2

"$(dirname "$0")/../npm_ci.sh" "$source" "$folder"
cd "$folder"
rm -rf viewer report tests
for part in viewer report tests tsconfig.json; do
  cp -R "$source/$part" .
done
rm -rf report/dist
npm run build
