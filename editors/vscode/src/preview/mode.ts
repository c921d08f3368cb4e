// What the settings say of when and how a preview is drawn.

import * as vscode from "vscode";

/** Whether it follows each edit, and not only what is saved. */
export function followsTyping(): boolean {
  return vscode.workspace.getConfiguration("scenec").get("preview.update") !== "onSave";
}

/** Whether there is to be more than a draft. */
export function wantsFull(): boolean {
  return vscode.workspace.getConfiguration("scenec").get("quality") !== "draft";
}
