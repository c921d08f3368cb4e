// A folder that is not trusted: everything works, and a server that the folder names is not started.

import assert from "node:assert/strict";
import { chmodSync, existsSync, writeFileSync } from "node:fs";
import path from "node:path";
import { test } from "node:test";

import { PATIENCE, shot, startCode } from "./code.ts";
import { BALL } from "./scenes.ts";
import { isRed, Window } from "./window.ts";

test("a folder that is not trusted names no server", { timeout: 5 * PATIENCE }, async context => {
  const trap = {
    "security.workspace.trust.enabled": true,
    "security.workspace.trust.startupPrompt": "never",
  };
  const code = await startCode({ "ball.scene": BALL }, {}, trap);
  const program = path.join(code.folder, "program");
  const trace = path.join(code.folder, "was-here");
  writeFileSync(program, `#!/bin/sh\ntouch '${trace}'\n`);
  chmodSync(program, 0o755);
  code.set({ "scenec.server.path": program });
  let window: Window | undefined;
  try {
    window = await Window.open(code, "ball.scene");
    await window.page.locator("#status\\.workspaceTrust", { hasText: "Restricted Mode" }).waitFor();
    await window.editor
      .locator(".squiggly-warning, .squiggly-unnecessary")
      .first()
      .waitFor({ state: "attached" });
    await window.hover("red", "diffref");
    await window.run("Scene: Open Preview to the Side");
    await window.middle("a red ball", isRed);
    assert.equal(code.servers().length, 1);
    assert.ok(!existsSync(trace), "the folder's program was run");
    await shot(window.page, "restricted");
  } catch (error) {
    await window?.failed({ passed: false, name: context.name });
    throw error;
  } finally {
    await code.close();
  }
});
