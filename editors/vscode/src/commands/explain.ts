// The pages of the rules, from the program itself: a finding's code is a link to its page.

import { execFile } from "node:child_process";
import { promisify } from "node:util";

import * as vscode from "vscode";
import type { Middleware } from "vscode-languageclient/node";

import type { Session } from "../server/session.ts";

/** The manifest says that such pages are shown as they read. */
const SCHEME = "scenec-rule";

/** Makes the codes of findings links, whichever way the findings come. */
export const linksToPages: Middleware = {
  handleDiagnostics(uri, found, next) {
    next(uri, found.map(link));
  },
  async provideDiagnostics(document, previous, token, next) {
    const report = await next(document, previous, token);
    return report?.kind === "full" ? { ...report, items: report.items.map(link) } : report;
  },
};

/**
 * The link of a finding. The server's own leads to a file, which would be shown as it is written, and could be changed; this
 * one is shown as it reads. It can't be a command: a hover follows none.
 */
function link(finding: vscode.Diagnostic): vscode.Diagnostic {
  const value = typeof finding.code === "object" ? finding.code.value : finding.code;
  if (typeof value === "string") {
    finding.code = { value, target: vscode.Uri.from({ scheme: SCHEME, path: `/${value}.md` }) };
  }
  return finding;
}

/** Offers the pages. */
export function rulePages(session: Session): vscode.Disposable {
  return vscode.workspace.registerTextDocumentContentProvider(SCHEME, {
    async provideTextDocumentContent(page) {
      const server = session.locate();
      if (!server.found) {
        return server.reason;
      }
      const rule = page.path.match(/^\/([A-Z]\d{3})\.md$/)?.[1];
      return rule && (await promisify(execFile)(server.file, ["explain", rule])).stdout;
    },
  });
}
