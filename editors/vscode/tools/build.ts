// Bundles the extension and the page of its preview into dist/.

import { copyFileSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import path from "node:path";

import { build } from "esbuild";

const ROOT = path.join(import.meta.dirname, "..");
const from = (name: string) => path.join(ROOT, "src", name);
const to = (name: string) => path.join(ROOT, "dist", name);
const common = { bundle: true, minify: true, logLevel: "warning", legalComments: "linked" } as const;

/** The licences of what is bundled, as these ask for. */
function notices(inputs: string[]): string {
  const packages = inputs.flatMap(input => input.match(/^(?:.*\/)?node_modules\/(?:@[^/]+\/)?[^/]+/) ?? []);
  const texts = [...new Set(packages)].sort().map(folder => {
    const file = readdirSync(folder).find(name => /^licen[cs]e/i.test(name));
    const { name, license } = JSON.parse(readFileSync(path.join(folder, "package.json"), "utf8"));
    return `${name}: ${license}\n\n${file ? readFileSync(path.join(folder, file), "utf8").trim() : ""}\n`;
  });
  return texts.join(`\n${"-".repeat(72)}\n\n`);
}

process.chdir(ROOT);
const { metafile } = await build({
  ...common,
  metafile: true,
  entryPoints: [from("extension.ts")],
  outfile: to("extension.cjs"),
  platform: "node",
  format: "cjs",
  target: "node20",
  external: ["vscode"],
});
await build({
  ...common,
  entryPoints: [from("webview/main.ts")],
  outfile: to("preview.js"),
  platform: "browser",
  format: "iife",
  target: "chrome120",
});
await build({ ...common, entryPoints: [from("webview/preview.css")], outfile: to("preview.css") });
copyFileSync(path.join(ROOT, "../../scenes/snowman.scene"), to("example.scene"));
writeFileSync(to("THIRD-PARTY.txt"), notices(Object.keys(metafile.inputs)));
