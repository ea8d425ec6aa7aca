// SPDX-License-Identifier: Apache-2.0
// validate.mjs FILE...: what the Khronos validator finds in glTF files; exits with 1 where it finds an error.
import { readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { validateBytes } from "gltf-validator";

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
