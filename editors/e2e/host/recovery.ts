// The server that ends, and the one that can't be found.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";

import * as vscode from "vscode";

import { scene } from "../scenes.ts";
import { code, findings, open, replace, type Tests, until } from "./tools.ts";

/** The servers that this editor has started. */
function servers(): number[] {
  const children = execFileSync("ps", ["--ppid", String(process.pid), "-o", "pid=,args="], {
    encoding: "utf8",
  });
  return children
    .split("\n")
    .filter(line => / lsp\b/.test(line))
    .map(line => Number.parseInt(line, 10));
}

export const tests: Tests = {
  async "a server that ends by itself is started anew"() {
    const editor = await open(scene("!ball := sphere", "!ball <="));
    const [first] = await until("a server", () => {
      const found = servers();
      return found.length === 1 && found;
    });
    assert.ok(first);
    process.kill(first, "SIGKILL");
    await until("another server", () => {
      const found = servers();
      return found.length === 1 && found[0] !== first;
    });
    await replace(editor, "sphere", "cube");
    await findings(editor.document.uri, "E008", found => found.some(it => code(it) === "E008"));
  },

  async "the command starts the server anew"() {
    const before = servers();
    await vscode.commands.executeCommand("scenec.restart");
    await until("another server", () => {
      const found = servers();
      return found.length === 1 && found[0] !== before[0];
    });
    const editor = await open(scene("!ball := cube", "!ball <="));
    await findings(editor.document.uri, "E008", found => found.some(it => code(it) === "E008"));
  },

  async "a server that is not there is told of, and the right one found again"() {
    const settings = vscode.workspace.getConfiguration("scenec");
    await settings.update("server.path", "/nowhere/scenec", vscode.ConfigurationTarget.Global);
    await until("no server", () => servers().length === 0);
    await settings.update("server.path", undefined, vscode.ConfigurationTarget.Global);
    await until("a server", () => servers().length === 1);
    const editor = await open(scene("!ball := cube", "!ball <="));
    await findings(editor.document.uri, "E008", found => found.some(it => code(it) === "E008"));
  },
};
