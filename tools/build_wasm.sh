#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# tools/build_wasm.sh [OPTIONS OF cmake --build]: the library for WebAssembly and the programs that test it, in build/wasm;
# nothing where their compiler is not here.
set -eu
cd "$(dirname "$0")/.."
missing=$(tools/setup.sh --missing wasm)
[ -z "$missing" ] || { echo "skipped: WebAssembly; not here: $missing"; exit 0; }
cmake --preset wasm
cmake --build --preset wasm "$@"
