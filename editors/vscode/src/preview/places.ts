// Places in a file's editor: where its cursor is, and how to go somewhere.

import * as vscode from "vscode";

/** An editor that shows this file, the active one first. */
function editorOf(uri: vscode.Uri): vscode.TextEditor | undefined {
  const editors = [vscode.window.activeTextEditor, ...vscode.window.visibleTextEditors];
  return editors.find(editor => editor?.document.uri.toString() === uri.toString());
}

/** Where the cursor of a file's editor is, if one is to be seen. */
export function cursorIn(uri: vscode.Uri): vscode.Position | undefined {
  return editorOf(uri)?.selection.active;
}

/** Selects a place in the file's editor, and opens one if there is none. */
export async function show(uri: vscode.Uri, selection: vscode.Range): Promise<void> {
  const tab = vscode.window.tabGroups.all
    .flatMap(group => group.tabs)
    .find(tab => tab.input instanceof vscode.TabInputText && tab.input.uri.toString() === uri.toString());
  const viewColumn = editorOf(uri)?.viewColumn ?? tab?.group.viewColumn ?? vscode.ViewColumn.One;
  const editor = await vscode.window.showTextDocument(uri, { viewColumn, selection });
  editor.revealRange(selection, vscode.TextEditorRevealType.InCenterIfOutsideViewport);
}
