// Records what an editor says first, for the tests of the server: `SCENEC=PROGRAM node record.ts FILE code`, with the package
// in SCENEC_VSIX, or `node record.ts FILE nvim`, with a Neovim. What is of one machine alone is replaced.

import { execFileSync } from "node:child_process";
import { chmodSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import path from "node:path";

import { startCode } from "./code.ts";
import { BALL } from "./scenes.ts";
import { Window } from "./window.ts";

const EDITORS = path.join(import.meta.dirname, "..");
const FOLDER = "/home/me/scenes";

/** A program that passes everything on to the server and keeps a copy of it. */
function tap(folder: string, copy: string): string {
  const file = path.join(folder, "tap");
  writeFileSync(file, `#!/bin/sh\ntee '${copy}' | { '${process.env.SCENEC}' lsp; kill $$; }\n`);
  chmodSync(file, 0o755);
  return file;
}

async function fromCode(folder: string, copy: string): Promise<string> {
  const code = await startCode({ "a.scene": BALL }, {}, { "scenec.server.path": tap(folder, copy) });
  try {
    const window = await Window.open(code, "a.scene");
    await window.editor
      .locator(".squiggly-warning, .squiggly-unnecessary")
      .first()
      .waitFor({ state: "attached" });
    return code.folder;
  } finally {
    await code.close();
  }
}

function fromNeovim(folder: string, copy: string, program: string): string {
  const scene = path.join(folder, "a.scene");
  writeFileSync(scene, BALL);
  const its = { XDG_STATE_HOME: folder, XDG_DATA_HOME: folder, XDG_CACHE_HOME: folder };
  const env = {
    ...process.env,
    ...its,
    SCENEC: tap(folder, copy),
    SCENE_EDITORS: EDITORS,
    SCENE_FILE: scene,
  };
  const options = { cwd: folder, env: { ...env, SCENE_FOLDER: folder }, stdio: "inherit" } as const;
  const script = `luafile ${path.join(EDITORS, "neovim/test.lua")}`;
  execFileSync(program, ["--headless", "-u", "NONE", "-i", "NONE", "-n", "-c", script], options);
  return folder;
}

/** The first message of a stream. */
function first(stream: string): string {
  const end = stream.indexOf("\r\n\r\n") + 4;
  const length = Number(stream.slice(0, end).match(/Content-Length: (\d+)/)?.[1]);
  return Buffer.from(stream)
    .subarray(Buffer.byteLength(stream.slice(0, end)))
    .subarray(0, length)
    .toString();
}

const [file = "", editor = ""] = process.argv.slice(2);
const folder = mkdtempSync("/tmp/record-");
try {
  mkdirSync(folder, { recursive: true });
  const copy = path.join(folder, "stream");
  const opened = editor === "code" ? await fromCode(folder, copy) : fromNeovim(folder, copy, editor);
  const words = first(readFileSync(copy, "utf8")).replaceAll(opened, FOLDER);
  const message = JSON.parse(words.replaceAll(/"name":"ws"/g, '"name":"scenes"'));
  message.params.processId = null;
  if (editor === "code") {
    message.params.initializationOptions.server.path = "";
  }
  writeFileSync(file, `${JSON.stringify(message, null, 1)}\n`);
} finally {
  rmSync(folder, { recursive: true, force: true });
}
