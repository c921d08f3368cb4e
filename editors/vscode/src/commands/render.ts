// Rendering a file to a picture file, by the program itself.

import { spawn } from "node:child_process";
import path from "node:path";

import * as vscode from "vscode";

import type { Session } from "../server/session.ts";
import formats from "./formats.json" with { type: "json" };

/** Asks where to, renders the text as it stands in the editor, and offers to show the picture. */
export async function renderToFile(session: Session, uri: vscode.Uri, chosen?: vscode.Uri): Promise<void> {
  const server = session.locate();
  if (!server.found) {
    void vscode.window.showErrorMessage(`Scene: ${server.reason}`);
    return;
  }
  const document = await vscode.workspace.openTextDocument(uri);
  const target = chosen ?? (await askTarget(uri));
  if (target === undefined) {
    return;
  }
  const settings = vscode.workspace.getConfiguration("scenec", uri);
  const args = ["render", "-", "--output", target.fsPath, "--color", "never", "--quiet"];
  args.push("--device", settings.get("device", "auto"), "--csg", settings.get("csg", "tree"));
  const name = path.basename(target.fsPath);
  const progress = {
    location: vscode.ProgressLocation.Notification,
    title: `Rendering ${name}`,
    cancellable: true,
  };
  const trouble = await vscode.window.withProgress(progress, (_, token) =>
    run(server.file, args, document.getText(), token),
  );
  if (trouble === undefined) {
    void offer(target, name);
  } else if (trouble !== "cancelled") {
    void vscode.window.showErrorMessage(`Scene: ${trouble}`);
  }
}

function askTarget(uri: vscode.Uri): Thenable<vscode.Uri | undefined> {
  const stem = uri.scheme === "file" ? uri.fsPath.replace(/\.\w+$/, "") : "scene";
  return vscode.window.showSaveDialog({
    defaultUri: vscode.Uri.file(`${stem}.png`),
    filters: formats,
    saveLabel: "Render",
  });
}

async function offer(target: vscode.Uri, name: string): Promise<void> {
  const open = "Open";
  if ((await vscode.window.showInformationMessage(`Scene: ${name} is rendered.`, open)) === open) {
    await vscode.commands.executeCommand("vscode.open", target);
  }
}

/** Runs the program; what went wrong, if anything did. */
function run(
  file: string,
  args: string[],
  text: string,
  token: vscode.CancellationToken,
): Promise<string | undefined> {
  return new Promise(resolve => {
    const child = spawn(file, args, { stdio: ["pipe", "ignore", "pipe"] });
    let reports = "";
    child.stderr.on("data", data => {
      reports += data;
    });
    child.on("error", error => resolve(error.message));
    child.on("close", code => {
      if (token.isCancellationRequested) {
        resolve("cancelled");
      } else {
        resolve(code === 0 ? undefined : firstReport(reports) || `the program ended with ${code}`);
      }
    });
    token.onCancellationRequested(() => child.kill("SIGINT"));
    child.stdin.on("error", () => undefined);
    child.stdin.end(text);
  });
}

/** The first line that says something: the rest stands under the words in the editor. */
function firstReport(reports: string): string {
  return reports.split("\n").find(line => line.trim() !== "") ?? "";
}
