#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# run.sh PROGRAM: runs a program of WebAssembly in Node, or says why it skips it (exit 77).
set -eu
missing=$("$(dirname "$0")/../../tools/setup.sh" --missing wasm)
[ -z "$missing" ] || { echo "skipped: not here: $missing; tools/setup.sh wasm installs what it can"; exit 77; }
[ -f "$1" ] || { echo "skipped: $(basename "$1") is not built; tools/build_wasm.sh builds it"; exit 77; }
exec node --no-warnings "$(dirname "$0")/run.mjs" "$1"
