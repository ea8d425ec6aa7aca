#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# build.sh COMMAND MODULES WORK PACKAGE: the npm package in the folder PACKAGE, ready for `npm pack`. COMMAND is the built orispline, which lists the
# methods; MODULES the folder of the compiled modules, of which those are taken that are there; WORK a folder for the tools of the lock file. Skips as
# tests/npm_ci.sh does (exit 77).
set -eu
source=$(cd "$(dirname "$0")" && pwd)
root=$source/../..
command=$1
modules=$2
work=$3
package=$4

"$root/tests/npm_ci.sh" "$source" "$work"
"$command" tasks --json | node "$source/tasks.mjs" | cmp -s - "$source/src/task_types.ts" || {
  echo "found src/task_types.ts of other tasks, wanted that of: orispline tasks --json | node bindings/npm/tasks.mjs >bindings/npm/src/task_types.ts" >&2
  exit 1
}
rm -rf "$work/src" "$package"
mkdir -p "$package"
cp -R "$source/src" "$source/tsconfig.json" "$work"
"$command" methods --json | node "$source/lite/methods.mjs" "$root/src/lite/orispline/families/families.hpp" >"$work/src/lite_methods.ts"
printf '// SPDX-License-Identifier: Apache-2.0\nexport const moduleText: string = "%s";\n' \
  "$([ ! -f "$modules/lite.wasm" ] || base64 -w 0 "$modules/lite.wasm")" >"$work/src/lite_module.ts"
"$work/node_modules/.bin/tsc" --project "$work" --outDir "$package"
for module in "$modules"/*.wasm; do
  [ ! -f "$module" ] || cp "$module" "$package"
done
cp "$source/README.md" "$root/LICENSE" "$root/NOTICE" "$root/THIRD_PARTY" "$package"
node -e '
  const { readFileSync, writeFileSync } = require("node:fs");
  const { devDependencies, scripts, ...kept } = JSON.parse(readFileSync(process.argv[1]));
  writeFileSync(process.argv[2], JSON.stringify(kept, null, 2) + "\n");' "$source/package.json" "$package/package.json"
