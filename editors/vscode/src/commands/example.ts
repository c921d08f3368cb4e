// An example to play with.

import * as vscode from "vscode";

/** Opens the example as a file that is nowhere yet. */
export async function openExample(extension: vscode.Uri): Promise<vscode.TextEditor> {
  const bytes = await vscode.workspace.fs.readFile(vscode.Uri.joinPath(extension, "dist", "example.scene"));
  const content = new TextDecoder().decode(bytes);
  const document = await vscode.workspace.openTextDocument({ language: "scene", content });
  return vscode.window.showTextDocument(document);
}
