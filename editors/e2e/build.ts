// Bundles the tests that run inside the extension host: the editor loads one CommonJS file.

import { createRequire } from "node:module";
import path from "node:path";

const HERE = import.meta.dirname;
const require = createRequire(path.join(HERE, "../vscode/package.json"));
const { buildSync } = require("esbuild") as {
  buildSync(options: object): unknown;
};

buildSync({
  entryPoints: [path.join(HERE, "host/index.ts")],
  outfile: path.join(HERE, "build/host.cjs"),
  bundle: true,
  platform: "node",
  format: "cjs",
  target: "node24",
  external: ["vscode"],
  logLevel: "warning",
});
