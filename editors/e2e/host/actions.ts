// Changes to a file through the editor's own programming interface.

import assert from "node:assert/strict";

import * as vscode from "vscode";

import { BALL, scene } from "../scenes.ts";
import { ask, at, code, findings, open, replace, type Tests, until } from "./tools.ts";

export const tests: Tests = {
  async "renaming reaches every use"() {
    const { document } = await open(BALL);
    const edit = await until("a renaming", () =>
      ask<vscode.WorkspaceEdit | undefined>(
        "vscode.executeDocumentRenameProvider",
        document.uri,
        at(document, "!ball", 1),
        "kugel",
      ),
    );
    assert.ok(await vscode.workspace.applyEdit(edit));
    assert.ok(!document.getText().includes("ball"), document.getText());
    assert.equal(document.getText().match(/!kugel/g)?.length, 4);
  },

  async "a name that is none is refused"() {
    const { document } = await open(BALL);
    const renaming = ask(
      "vscode.executeDocumentRenameProvider",
      document.uri,
      at(document, "!ball", 1),
      "two words",
    );
    await assert.rejects(async () => renaming);
  },

  async "a repair is offered for a misspelt word and mends it"() {
    const { document } = await open(scene("!ball := shpere", "!ball <="));
    const [finding] = await findings(document.uri, "E008", found => found.some(it => code(it) === "E008"));
    assert.ok(finding);
    const actions = await ask<vscode.CodeAction[]>(
      "vscode.executeCodeActionProvider",
      document.uri,
      finding.range,
    );
    const fix = actions.find(action => action.edit !== undefined && action.title.includes("sphere"));
    assert.ok(fix?.edit, actions.map(action => action.title).join(", "));
    assert.ok(await vscode.workspace.applyEdit(fix.edit));
    assert.ok(document.getText().includes("!ball := sphere"));
    await findings(document.uri, "no findings", found => found.length === 0);
  },

  async "what a file lacks is added, and what stands too late is moved"() {
    const text = scene(
      "!a := sphere",
      "!b := hp",
      "!both := a - b",
      "!both += 0 1 0",
      "!both ?= red",
      "!both <=",
    );
    const { document } = await open(text.replace("width := 120\n", ""));
    const take = async (rule: string, title: RegExp) => {
      const found = await findings(document.uri, rule, found => found.some(it => code(it) === rule));
      const { range } = found.find(it => code(it) === rule) ?? assert.fail(rule);
      const actions = await ask<vscode.CodeAction[]>("vscode.executeCodeActionProvider", document.uri, range);
      const action = actions.find(action => title.test(action.title));
      assert.ok(action?.edit, actions.map(action => action.title).join(", "));
      assert.ok(await vscode.workspace.applyEdit(action.edit));
      await findings(document.uri, `no ${rule}`, found => !found.some(it => code(it) === rule));
    };
    await take("E010", /transform the 2 base objects before/);
    await take("E014", /add the missing setting/);
    await take("W003", /create the material/);
    const words = document.getText();
    assert.match(
      words,
      /!a \+= 0 1 0[\s\S]*!b \+= 0 1 0[\s\S]*!both := a - b\n\?red := [\s\S]*!both \?= red/,
    );
    assert.match(words, /^width := \d+$/m);
  },

  async "everything that is certain is repaired at once"() {
    const { document } = await open(BALL);
    await findings(document.uri, "W005", found => found.some(it => code(it) === "W005"));
    // The editor passes the command over until it has asked what repairs there are.
    await until("the late edit is gone", async () => {
      await vscode.commands.executeCommand("scenec.fixAll");
      return !document.getText().includes("+=");
    });
  },

  async "saving repairs and formats where that is wanted"() {
    const editor = await open(BALL);
    const { document } = editor;
    await findings(document.uri, "W005", found => found.some(it => code(it) === "W005"));
    const settings = vscode.workspace.getConfiguration("editor", { uri: document.uri, languageId: "scene" });
    const wanted = { codeActionsOnSave: { "source.fixAll": "explicit" }, formatOnSave: true };
    const set = async (on: boolean) => {
      for (const [name, value] of Object.entries(wanted)) {
        const target = vscode.ConfigurationTarget.Workspace;
        await settings.update(name, on ? value : undefined, target, true);
      }
    };
    await set(true);
    try {
      await replace(editor, "!ball := sphere", "!ball:=sphere");
      assert.ok(await document.save());
      const text = document.getText();
      assert.ok(text.includes("!ball := sphere") && !text.includes("+="), text);
    } finally {
      await set(false);
    }
  },

  async "formatting makes one style"() {
    const { document } = await open(`${BALL}!x:=sphere\n`);
    const edits = await until("edits", () =>
      ask<vscode.TextEdit[] | undefined>("vscode.executeFormatDocumentProvider", document.uri, {
        tabSize: 2,
        insertSpaces: true,
      }),
    );
    const edit = new vscode.WorkspaceEdit();
    edit.set(document.uri, edits);
    assert.ok(await vscode.workspace.applyEdit(edit));
    assert.ok(document.getText().endsWith("!x := sphere\n"), document.getText());
  },
};
