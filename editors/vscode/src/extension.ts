// The extension: its parts, and what the editor's commands ask of them.

import * as vscode from "vscode";
import { openExample } from "./commands/example.ts";
import { linksToPages, rulePages } from "./commands/explain.ts";
import { Plans } from "./commands/plan.ts";
import { renderToFile } from "./commands/render.ts";
import { Previews } from "./preview/previews.ts";
import { Session } from "./server/session.ts";
import { snippetsWithoutServer } from "./snippets.ts";
import { statusItem } from "./status.ts";
import { Tasks } from "./tasks.ts";

let session: Session | undefined;

export async function activate(context: vscode.ExtensionContext): Promise<void> {
  session = new Session(context.extensionPath, linksToPages);
  const previews = new Previews(context.extensionUri, session);
  const plans = new Plans(session);
  const tasks = new Tasks(session);
  context.subscriptions.push(
    session,
    previews,
    plans.register(),
    tasks.register(),
    rulePages(session),
    snippetsWithoutServer(session),
    statusItem(session),
  );
  context.subscriptions.push(
    vscode.workspace.onDidChangeConfiguration(event => {
      if (event.affectsConfiguration("scenec.server.path")) {
        void session?.restart();
      }
    }),
  );
  register(context, session, previews, plans);
  await session.start();
}

export async function deactivate(): Promise<void> {
  await session?.stop();
}

function register(
  context: vscode.ExtensionContext,
  session: Session,
  previews: Previews,
  plans: Plans,
): void {
  const commands: Record<string, (...args: never[]) => unknown> = {
    preview: onFile(previews, uri => previews.open(uri)),
    render: onFile(previews, (uri, target) => renderToFile(session, uri, target)),
    showPlan: onFile(previews, uri => plans.show(uri)),
    fixAll: () => vscode.commands.executeCommand("editor.action.fixAll"),
    writeCamera: () => previews.current?.write(),
    resetCamera: () => previews.current?.reset(),
    openExample: () => openExample(context.extensionUri),
    restart: () => session.restart(),
    showLog: () => session.showLog(),
    showReferences: session.showPlaces.bind(session),
  };
  for (const [name, run] of Object.entries(commands)) {
    context.subscriptions.push(vscode.commands.registerCommand(`scenec.${name}`, run));
  }
}

/** A command about a file: the one that it is given, or the one in front. */
function onFile(previews: Previews, run: (uri: vscode.Uri, target?: vscode.Uri) => unknown) {
  return (given?: vscode.Uri | string, target?: vscode.Uri) => {
    const uri = typeof given === "string" ? vscode.Uri.parse(given) : given;
    const front = vscode.window.activeTextEditor?.document;
    const file = uri ?? (front?.languageId === "scene" ? front.uri : previews.current?.uri);
    if (file === undefined) {
      void vscode.window.showInformationMessage("Scene: open a scene file first.");
      return undefined;
    }
    return run(file, target instanceof vscode.Uri ? target : undefined);
  };
}
