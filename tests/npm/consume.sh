#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# consume.sh PACKED: installs the packed file of the npm package in an empty folder, and runs the examples of its README there, as they stand.
# ORISPLINE_COMMAND is the command that they call; without it build/release/orispline.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
packed=$(realpath "$1")
command=$(realpath "${ORISPLINE_COMMAND:-$here/../../build/release/orispline}")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cp "$here/../../examples/data/five_keys.csv" "$folder/keys.csv"
cp "$here/fetch_files.mjs" "$folder"
cd "$folder"
npm install --offline --no-audit --no-fund --silent "$packed"
mkdir bin && ln -s "$command" bin/orispline

# The blocks of code in their order: those of shells, and those of JavaScript as modules of their own.
awk -v fence='```' '
  index($0, fence) == 1 { language = language ? "" : substr($0, 4); if (language) ++count; next }
  language == "sh" || language == "js" { print > sprintf("%02d.%s", count, language) }' node_modules/orispline/README.md
for example in [0-9]*.sh [0-9]*.js; do
  [ -f "$example" ] || { echo "consume.sh: found no $example in the README, wanted an example" >&2; exit 1; }
done
for example in [0-9]*; do
  case $example in
    *.sh) grep -v '^npm ' "$example" >words || true; PATH=$PWD/bin:$PATH sh -eu words ;;
    *.js) mv "$example" "${example%.js}.mjs"; node --import ./fetch_files.mjs "${example%.js}.mjs" ;;
  esac
  echo "$example runs"
done
