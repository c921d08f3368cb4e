// The extension's own commands, tasks and settings.

import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import path from "node:path";

import * as vscode from "vscode";

import { BALL } from "../scenes.ts";
import { ask, code, findings, folder, open, type Tests, until } from "./tools.ts";

const PNG = "89504e470d0a1a0a";

/** The tab of the preview of a file. */
function previewOf(uri: vscode.Uri): vscode.Tab | undefined {
  const name = `Preview ${path.basename(uri.fsPath)}`;
  return vscode.window.tabGroups.all.flatMap(group => group.tabs).find(tab => tab.label === name);
}

export const tests: Tests = {
  async "every command of the manifest is there"() {
    const manifest = vscode.extensions.getExtension("scenec.scenec")?.packageJSON;
    const there = await vscode.commands.getCommands(true);
    for (const { command } of manifest.contributes.commands) {
      assert.ok(there.includes(command), command);
    }
  },

  async "every step of the walkthrough leads somewhere"() {
    const extension = vscode.extensions.getExtension("scenec.scenec") ?? assert.fail("the extension");
    const there = await vscode.commands.getCommands(true);
    const { steps } = extension.packageJSON.contributes.walkthroughs[0];
    assert.ok(steps.length > 3);
    for (const { description, media } of steps) {
      assert.ok(existsSync(path.join(extension.extensionPath, media.markdown)), media.markdown);
      const commands = [...description.matchAll(/\(command:([^)]+)\)/g)].map(found => found[1]);
      assert.ok(
        commands.every(command => there.includes(command)),
        `${commands}`,
      );
    }
  },

  async "rendering to a file"() {
    const { document } = await open(BALL);
    const target = vscode.Uri.file(path.join(folder(), "ball.png"));
    void vscode.commands.executeCommand("scenec.render", document.uri, target);
    const bytes = await until("the whole picture", () => {
      const found = existsSync(target.fsPath) && readFileSync(target.fsPath);
      return found && found.subarray(-8, -4).toString() === "IEND" && found;
    });
    assert.equal(bytes.subarray(0, 8).toString("hex"), PNG);
    assert.deepEqual([bytes.readUInt32BE(16), bytes.readUInt32BE(20)], [120, 80]);
  },

  async "a preview opens beside the text, once, and leaves the cursor where it is"() {
    const { document } = await open(BALL);
    await vscode.commands.executeCommand("scenec.preview");
    const tab = await until("the preview", () => previewOf(document.uri));
    assert.notEqual(tab.group.viewColumn, vscode.window.activeTextEditor?.viewColumn);
    assert.equal(vscode.window.activeTextEditor?.document, document);
    const count = vscode.window.tabGroups.all.flatMap(group => group.tabs).length;
    await vscode.commands.executeCommand("scenec.preview", document.uri.toString());
    assert.equal(vscode.window.tabGroups.all.flatMap(group => group.tabs).length, count);
    await vscode.window.tabGroups.close(tab);
  },

  async "the page about the plan opens"() {
    await open(BALL);
    await vscode.commands.executeCommand("scenec.showPlan");
    const tab = await until("the page", () =>
      vscode.window.tabGroups.all.flatMap(group => group.tabs).find(tab => tab.label.includes(".scene.md")),
    );
    await until("its text", () => {
      const page = vscode.workspace.textDocuments.find(document => document.uri.scheme === "scenec-plan");
      return page?.getText().includes("base objects");
    });
    await vscode.window.tabGroups.close(tab);
  },

  async "the page of a finding is shown as it reads"() {
    await vscode.commands.executeCommand("vscode.open", vscode.Uri.parse("scenec-rule:/W005.md"));
    const tab = await until("the page", () =>
      vscode.window.tabGroups.all.flatMap(group => group.tabs).find(tab => tab.label.includes("W005.md")),
    );
    const { input } = tab;
    assert.ok(input instanceof vscode.TabInputCustom && input.viewType.includes("markdown"), `${input}`);
    await vscode.window.tabGroups.close(tab);
  },

  async "the example is a scene without findings"() {
    const editor = (await vscode.commands.executeCommand("scenec.openExample")) as vscode.TextEditor;
    assert.equal(editor.document.languageId, "scene");
    assert.ok(editor.document.getText().includes("<="));
    await vscode.commands.executeCommand("workbench.action.revertAndCloseActiveEditor");
  },

  async "lenses stand above the submission"() {
    const { document } = await open(BALL);
    const lenses = await until("lenses", async () => {
      const found = await ask<vscode.CodeLens[]>("vscode.executeCodeLensProvider", document.uri, 10);
      return found.length > 0 && found;
    });
    assert.ok(
      lenses.some(lens => lens.command?.command === "scenec.preview"),
      JSON.stringify(lenses),
    );
    const settings = vscode.workspace.getConfiguration("scenec");
    await settings.update("lens", false, vscode.ConfigurationTarget.Workspace);
    await until("no lenses", async () => {
      const found = await ask<vscode.CodeLens[]>("vscode.executeCodeLensProvider", document.uri, 10);
      return found.length === 0;
    });
    await settings.update("lens", undefined, vscode.ConfigurationTarget.Workspace);
  },

  async "the task checks the folder and its problems are read"() {
    const { document } = await open("!ball := cube\n");
    const tasks = await vscode.tasks.fetchTasks({ type: "scenec" });
    const check = tasks.find(task => task.name === "check");
    assert.ok(check, tasks.map(task => task.name).join(", "));
    const task = new vscode.Task(
      { ...check.definition, paths: [path.basename(document.uri.fsPath)] },
      check.scope ?? vscode.TaskScope.Workspace,
      check.name,
      check.source,
    );
    const ended = new Promise(resolve => vscode.tasks.onDidEndTask(resolve));
    await vscode.tasks.executeTask(task.execution === undefined ? check : task);
    await ended;
    // Twice: once from the server, once from the task.
    await findings(document.uri, "a problem of the task", found => {
      const bad = found.filter(it => code(it) === "E008");
      return bad.length === 2 && bad.some(it => it.range.start.line === 0 && it.range.start.character === 9);
    });
  },
};
