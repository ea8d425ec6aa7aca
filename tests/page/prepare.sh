#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# prepare.sh SOURCE FOLDER [SCRIPT]: builds the page of the reports of SOURCE (studio), or what another script of its package builds, in FOLDER/*/dist
# with the packages of its lock file, or skips as npm_ci.sh does (exit 77). What it needs of the folder above SOURCE it puts above FOLDER.
set -eu
source=$1
folder=$2
script=${3:-build}

"$(dirname "$0")/../npm_ci.sh" "$source" "$folder"
cd "$folder"
rm -rf viewer report widget editor tests
for part in viewer report widget editor tests tsconfig.json pages.js; do
  cp -R "$source/$part" .
done
rm -rf */dist ../bindings ../examples
mkdir -p ../bindings/npm ../examples/data
cp "$source"/../examples/data/*_keys.csv ../examples/data
cp -R "$source/../bindings/npm/src" ../bindings/npm
cp "$source/../THIRD_PARTY" ..
npm run "$script"
