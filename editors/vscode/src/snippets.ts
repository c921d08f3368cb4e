// Statements to fill in for when no server offers its own: one of each is enough.

import * as vscode from "vscode";

import snippets from "../snippets/scene.json" with { type: "json" };
import type { Session } from "./server/session.ts";

interface Snippet {
  prefix: string;
  body: string | string[];
  description: string;
}

/** Offers the snippets at the beginning of a line. */
export function snippetsWithoutServer(session: Session): vscode.Disposable {
  return vscode.languages.registerCompletionItemProvider("scene", {
    provideCompletionItems(document, position) {
      const before = document.lineAt(position).text.slice(0, position.character);
      return session.serves(document) || !/^\s*[\w-]*$/.test(before) ? [] : items();
    },
  });
}

function items(): vscode.CompletionItem[] {
  const all: Snippet[] = Object.values(snippets);
  return all.map(({ prefix, body, description }) => {
    const item = new vscode.CompletionItem(prefix, vscode.CompletionItemKind.Snippet);
    item.insertText = new vscode.SnippetString(typeof body === "string" ? body : body.join("\n"));
    item.detail = description;
    return item;
  });
}
