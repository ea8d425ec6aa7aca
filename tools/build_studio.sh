#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# tools/build_studio.sh [OPTIONS OF cmake --build]: the page of the studio with the compiled library within it, build/studio/studio.html, and a folder that
# any host of files can serve, build/studio/site; nothing where the tools for one of both are not here.
set -eu
cd "$(dirname "$0")/.."
module=$PWD/build/wasm/bindings/npm/studio/studio.wasm
tools/build_wasm.sh "$@" --target orispline_npm_studio
[ -f "$module" ] || { echo "skipped: the studio, for it needs WebAssembly"; exit 0; }
export ORISPLINE_STUDIO_WASM="$module"
tests/page/prepare.sh "$PWD/studio" "$PWD/build/page/studio" studio || { [ $? = 77 ] && exit 0 || exit 1; }
page=build/page/studio/editor/dist/index.html
mkdir -p build/studio/site
cmp -s "$page" build/studio/studio.html || cp "$page" build/studio/studio.html
cp LICENSE NOTICE THIRD_PARTY build/studio/site
cp "$page" build/studio/site/index.html
