// Changes to a file through the editor's own programming interface.

import assert from "node:assert/strict";

import * as vscode from "vscode";

import { BALL, scene } from "../scenes.ts";
import { ask, at, code, findings, open, type Tests, until } from "./tools.ts";

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

  async "everything that is certain is repaired at once"() {
    const { document } = await open(BALL);
    await findings(document.uri, "W005", found => found.some(it => code(it) === "W005"));
    await vscode.commands.executeCommand("scenec.fixAll");
    await until("the late edit is gone", () => !document.getText().includes("+="));
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
