#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# npm_ci.sh SOURCE FOLDER: the packages of the lock file in SOURCE, in FOLDER/node_modules; once for each lock file. SOURCE may
# be a workspace. Without npm, a Node that is new enough, or a registry for what npm has not yet, it skips (exit 77).
set -eu
source=$1
folder=$2

skip() {
  echo "skipped: $1"
  exit 77
}

command -v npm >/dev/null && node -e '
  const [major, minor] = process.versions.node.split(".").map(Number);
  process.exit(major > 20 || (major === 20 && minor >= 19) ? 0 : 1)' || skip "npm with Node 20.19 or newer is not here"

mkdir -p "$folder"
cd "$folder"
cp "$source/package.json" "$source/package-lock.json" .
for member in "$source"/*/package.json; do
  [ -f "$member" ] || continue
  name=$(basename "$(dirname "$member")")
  mkdir -p "$name"
  cp "$member" "$name"
done
cmp -s package-lock.json node_modules/.installed && exit 0
npm ci --ignore-scripts --prefer-offline --no-audit --no-fund >npm.log 2>&1 || {
  cat npm.log >&2
  grep -Eq 'E(NOTFOUND|AI_AGAIN|CONNREFUSED|CONNRESET|TIMEDOUT|NETUNREACH|HOSTUNREACH)' npm.log \
    && skip "the registry of npm cannot be reached"
  exit 1
}
cp package-lock.json node_modules/.installed
