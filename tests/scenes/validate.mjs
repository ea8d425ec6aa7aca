// SPDX-License-Identifier: Apache-2.0
// validate.mjs FILE...: what the Khronos validator finds in glTF files; exits with 1 where it finds an error.
// It needs the npm package gltf-validator, in a folder that NODE_PATH names or where `npm root` or `npm root -g` says.
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { delimiter, dirname, join } from "node:path";

function npmRoot(...options) {
  try {
    return execFileSync("npm", ["root", ...options], { encoding: "utf8" }).trim();
  } catch {
    return "";
  }
}

function validator() {
  const folders = [() => process.env.NODE_PATH ?? "", () => npmRoot(), () => npmRoot("-g")];
  for (const folder of folders.flatMap((root) => root().split(delimiter)).filter(Boolean)) {
    try {
      return createRequire(join(folder, "here.js"))(join(folder, "gltf-validator"));
    } catch {
      continue;
    }
  }
  console.error("no gltf-validator: `npm install gltf-validator` anywhere, and name its node_modules in NODE_PATH");
  process.exit(2);
}

const { validateBytes } = validator();
const severities = ["error", "warning", "information", "hint"];
let errors = 0;
for (const file of process.argv.slice(2)) {
  const report = await validateBytes(new Uint8Array(readFileSync(file)), {
    uri: file,
    maxIssues: 0,
    externalResourceFunction: async (uri) => new Uint8Array(readFileSync(join(dirname(file), decodeURIComponent(uri)))),
  });
  for (const { severity, code, message, pointer } of report.issues.messages)
    if (severity < 2) console.log(`${file}: ${severities[severity]} ${code} ${pointer ?? ""}: ${message}`);
  const { numErrors, numWarnings, numInfos, numHints } = report.issues;
  console.log(`${file}: ${numErrors} errors, ${numWarnings} warnings, ${numInfos} infos, ${numHints} hints`);
  errors += numErrors;
}
process.exit(errors > 0 ? 1 : 0);
