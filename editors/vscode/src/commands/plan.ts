// A page on what of a scene is rendered and what is dropped, as the server tells it.

import * as vscode from "vscode";

import { plan } from "../protocol.ts";
import type { Session } from "../server/session.ts";

const SCHEME = "scenec-plan";

/** The pages of plans, by their own kind of address. */
export class Plans implements vscode.TextDocumentContentProvider {
  readonly #session: Session;
  readonly #changed = new vscode.EventEmitter<vscode.Uri>();
  readonly onDidChange = this.#changed.event;

  constructor(session: Session) {
    this.#session = session;
  }

  register(): vscode.Disposable {
    return vscode.workspace.registerTextDocumentContentProvider(SCHEME, this);
  }

  /** Shows the page of a file beside it, as it is now. */
  async show(uri: vscode.Uri): Promise<void> {
    const page = vscode.Uri.from({ scheme: SCHEME, path: `${uri.path}.md`, query: uri.toString() });
    this.#changed.fire(page);
    await vscode.commands.executeCommand("markdown.showPreviewToSide", page);
  }

  async provideTextDocumentContent(page: vscode.Uri): Promise<string> {
    const uri = vscode.Uri.parse(page.query);
    await vscode.workspace.openTextDocument(uri);
    const found = await this.#session.request(plan, { textDocument: { uri: this.#session.uri(uri) } });
    return found?.markdown ?? "The server has no plan for this file: see the problems in it.";
  }
}
