#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# prepare.sh FOLDER: the programs of this folder in FOLDER, beside the packages that they need, or skips as npm_ci.sh does
# (exit 77).
set -eu
here=$(cd "$(dirname "$0")" && pwd)
"$here/../../npm_ci.sh" "$here" "$1"
cp "$here"/*.mjs "$1"
