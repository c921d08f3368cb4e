// Packages the extension with a server inside: `node tools/package.ts --target linux-x64 --server PATH --out FILE.vsix`.
// Nothing is fetched, and the same inputs give the same bytes: times come from SOURCE_DATE_EPOCH.

import { chmodSync, cpSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { parseArgs } from "node:util";

import { createVSIX } from "@vscode/vsce";

const ROOT = path.join(import.meta.dirname, "..");
const LICENCES = ["LICENSE-APACHE", "LICENSE-MIT"];

const { values } = parseArgs({
  options: {
    target: { type: "string" },
    server: { type: "string" },
    out: { type: "string", default: path.join(ROOT, "build", "scenec.vsix") },
  },
});

/** A folder with what the package is made of, and no more. */
function stage(folder: string): void {
  const manifest = JSON.parse(readFileSync(path.join(ROOT, "package.json"), "utf8"));
  for (const name of manifest.files as string[]) {
    const from = LICENCES.includes(name) ? path.join(ROOT, "../..", name) : path.join(ROOT, name);
    if (name !== "server/") {
      cpSync(from, path.join(folder, name), { recursive: true });
    }
  }
  if (values.server !== undefined) {
    const name = values.target?.startsWith("win32") ? "scenec.exe" : "scenec";
    const file = path.join(folder, "server", name);
    mkdirSync(path.dirname(file));
    cpSync(values.server, file);
    chmodSync(file, 0o755);
  }
  delete manifest.scripts;
  delete manifest.devDependencies;
  writeFileSync(path.join(folder, "package.json"), `${JSON.stringify(manifest, null, 2)}\n`);
}

const folder = mkdtempSync(path.join(tmpdir(), "scenec-vsix-"));
try {
  process.env.SOURCE_DATE_EPOCH ??= "1700000000";
  stage(folder);
  mkdirSync(path.dirname(path.resolve(values.out)), { recursive: true });
  await createVSIX({
    cwd: folder,
    packagePath: path.resolve(values.out),
    dependencies: false,
    allowMissingRepository: true,
    skipLicense: true,
    ...(values.target === undefined ? {} : { target: values.target }),
  });
} finally {
  rmSync(folder, { recursive: true, force: true });
}
