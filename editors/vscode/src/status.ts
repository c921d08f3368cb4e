// The item in the status bar: how the server is, what renders, and how long the last picture took.

import * as vscode from "vscode";

import * as protocol from "./protocol.ts";
import type { Session } from "./server/session.ts";
import { type Facts, label } from "./statustext.ts";

/** Shows the item while a scene or a preview is in front. */
export function statusItem(session: Session): vscode.Disposable {
  const item = vscode.window.createStatusBarItem("scenec.status", vscode.StatusBarAlignment.Right, 90);
  item.name = "Scene";
  item.command = "scenec.showLog";
  let facts: Facts = { server: session.state.kind };
  const update = () => {
    const text = label(facts);
    item.text = text.short;
    item.tooltip = new vscode.MarkdownString(
      `${text.long}\n\n[Restart the server](command:scenec.restart) · [Show the log](command:scenec.showLog) · ` +
        "[Settings](command:workbench.action.openSettings?%22scenec%22)",
    );
    item.tooltip.isTrusted = {
      enabledCommands: ["scenec.restart", "scenec.showLog", "workbench.action.openSettings"],
    };
    item.backgroundColor =
      facts.server === "down" ? new vscode.ThemeColor("statusBarItem.errorBackground") : undefined;
    const tab = vscode.window.tabGroups.activeTabGroup.activeTab?.input;
    const preview = tab instanceof vscode.TabInputWebview && tab.viewType.endsWith("scenec.preview");
    if (vscode.window.activeTextEditor?.document.languageId === "scene" || preview) {
      item.show();
    } else {
      item.hide();
    }
  };
  session.onNotification(protocol.status, drawing => {
    facts = { ...facts, drawing };
    update();
  });
  const listeners = [
    session.onState(state => {
      facts = { server: state.kind, reason: state.reason, version: session.version };
      update();
    }),
    vscode.window.onDidChangeActiveTextEditor(update),
    vscode.window.tabGroups.onDidChangeTabs(update),
    vscode.window.tabGroups.onDidChangeTabGroups(update),
  ];
  update();
  return vscode.Disposable.from(item, ...listeners);
}
