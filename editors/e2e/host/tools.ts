// What the tests in the extension host share: files, waiting, and places named by their words.

import assert from "node:assert/strict";
import path from "node:path";

import * as vscode from "vscode";

export type Tests = Record<string, () => Promise<void>>;

let files = 0;

/** The folder that is open. */
export function folder(): string {
  const found = vscode.workspace.workspaceFolders?.[0];
  assert.ok(found, "a folder is open");
  return found.uri.fsPath;
}

/** Writes a file of its own for a test and shows it. */
export async function open(text: string, extension = "scene"): Promise<vscode.TextEditor> {
  const uri = vscode.Uri.file(path.join(folder(), `case-${++files}.${extension}`));
  await vscode.workspace.fs.writeFile(uri, Buffer.from(text));
  return vscode.window.showTextDocument(uri);
}

/** How long anything may take, in milliseconds: a machine may be busy. */
const PATIENCE = 120_000;

/** Asks until the answer is one. */
export async function until<T>(
  what: string,
  ask: () => T | undefined | false | Promise<T | undefined | false>,
): Promise<T> {
  const end = Date.now() + PATIENCE;
  for (;;) {
    const found = await ask();
    if (found !== undefined && found !== false) {
      return found;
    }
    assert.ok(Date.now() < end, `timed out: ${what}`);
    await new Promise(resolve => setTimeout(resolve, 25));
  }
}

/** The findings of a file once they are what is waited for. */
export function findings(
  uri: vscode.Uri,
  what: string,
  wanted: (found: vscode.Diagnostic[]) => boolean,
): Promise<vscode.Diagnostic[]> {
  return until(what, () => {
    const found = vscode.languages.getDiagnostics(uri);
    return wanted(found) && found;
  });
}

/** The code of a finding, without its link. */
export function code(finding: vscode.Diagnostic): string {
  const { code } = finding;
  return String(typeof code === "object" ? code.value : code);
}

/** Where `words` stand in a file; the place is inside them, `into` characters behind their start. */
export function at(document: vscode.TextDocument, words: string, into = 0): vscode.Position {
  const offset = document.getText().indexOf(words);
  assert.ok(offset >= 0, `${words} is not in the file`);
  return document.positionAt(offset + into);
}

/** Asks a provider by its command. */
export async function ask<T>(command: string, uri: vscode.Uri, ...args: unknown[]): Promise<T> {
  return vscode.commands.executeCommand<T>(command, uri, ...args);
}

/** Replaces `words` in a file. */
export async function replace(editor: vscode.TextEditor, words: string, by: string): Promise<void> {
  const start = at(editor.document, words);
  const range = new vscode.Range(start, start.translate(0, words.length));
  assert.ok(await editor.edit(change => change.replace(range, by)));
}
