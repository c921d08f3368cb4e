// All panels: one for each file that is shown. It hears what happens in the editor and tells the panel that it concerns.

import * as vscode from "vscode";

import * as protocol from "../protocol.ts";
import type { Session } from "../server/session.ts";
import type { PageState } from "../shared/messages.ts";
import { followsTyping } from "./mode.ts";
import { fill } from "./page.ts";
import { Preview } from "./panel.ts";

const VIEW = "scenec.preview";

export class Previews implements vscode.Disposable, vscode.WebviewPanelSerializer<PageState> {
  readonly #extension: vscode.Uri;
  readonly #session: Session;
  readonly #previews = new Map<string, Preview>();
  readonly #listeners: vscode.Disposable[];

  constructor(extension: vscode.Uri, session: Session) {
    this.#extension = extension;
    this.#session = session;
    session.onNotification(protocol.frame, frame => this.#of(vscode.Uri.parse(frame.uri))?.frame(frame));
    this.#listeners = [
      vscode.window.registerWebviewPanelSerializer(VIEW, this),
      session.onState(state => {
        if (state.kind === "running") {
          this.#all();
        }
      }),
      vscode.workspace.onDidChangeTextDocument(event => {
        if (event.contentChanges.length > 0 && followsTyping()) {
          this.#of(event.document.uri)?.changed();
        }
      }),
      vscode.workspace.onDidSaveTextDocument(document => {
        if (!followsTyping()) {
          this.#of(document.uri)?.saved();
        }
      }),
      vscode.window.onDidChangeTextEditorSelection(
        event => void this.#of(event.textEditor.document.uri)?.outline(),
      ),
      vscode.workspace.onDidChangeConfiguration(event => {
        if (event.affectsConfiguration("scenec")) {
          this.#all();
        }
      }),
    ];
  }

  /** Shows the panel of a file, beside the text if it is new. */
  open(uri: vscode.Uri): void {
    const there = this.#of(uri);
    if (there !== undefined) {
      there.panel.reveal(undefined, true);
      return;
    }
    const where = { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true };
    this.#adopt(uri, vscode.window.createWebviewPanel(VIEW, title(uri), where));
  }

  /** The panel that a command means: the one in front, or that of the file in front. */
  get current(): Preview | undefined {
    const panel = [...this.#previews.values()].find(preview => preview.panel.active);
    const editor = vscode.window.activeTextEditor;
    return panel ?? (editor && this.#of(editor.document.uri));
  }

  async deserializeWebviewPanel(panel: vscode.WebviewPanel, state: PageState | undefined): Promise<void> {
    if (state?.uri === undefined) {
      panel.dispose();
      return;
    }
    this.#adopt(vscode.Uri.parse(state.uri), panel);
  }

  dispose(): void {
    for (const listener of this.#listeners) {
      listener.dispose();
    }
    for (const preview of this.#previews.values()) {
      preview.dispose();
    }
  }

  #of(uri: vscode.Uri): Preview | undefined {
    return this.#previews.get(uri.toString());
  }

  #all(): void {
    for (const preview of this.#previews.values()) {
      preview.changed();
    }
  }

  #adopt(uri: vscode.Uri, panel: vscode.WebviewPanel): void {
    const preview = new Preview(uri, panel, this.#session);
    this.#previews.set(uri.toString(), preview);
    panel.title = title(uri);
    panel.iconPath = vscode.Uri.joinPath(this.#extension, "images", "icon.png");
    panel.webview.options = {
      enableScripts: true,
      localResourceRoots: [vscode.Uri.joinPath(this.#extension, "dist")],
    };
    panel.onDidDispose(() => {
      preview.dispose();
      this.#previews.delete(uri.toString());
    });
    fill(panel.webview, this.#extension, uri.toString());
  }
}

function title(uri: vscode.Uri): string {
  return `Preview ${uri.path.slice(uri.path.lastIndexOf("/") + 1)}`;
}
