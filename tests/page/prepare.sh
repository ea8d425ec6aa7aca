#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# prepare.sh SOURCE FOLDER: builds the page and the widget of SOURCE (studio) in FOLDER/*/dist with the packages of its lock file, or skips
# as npm_ci.sh does (exit 77).
set -eu
source=$1
folder=$2

"$(dirname "$0")/../npm_ci.sh" "$source" "$folder"
cd "$folder"
rm -rf viewer report widget editor tests
for part in viewer report widget editor tests tsconfig.json; do
  cp -R "$source/$part" .
done
rm -rf report/dist widget/dist
npm run build
