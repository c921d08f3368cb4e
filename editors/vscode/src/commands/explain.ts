// The pages of the rules, from the program itself: a finding's code is a link to its page.

import { execFile } from "node:child_process";
import { promisify } from "node:util";

import * as vscode from "vscode";
import type { Middleware } from "vscode-languageclient/node";

import type { Session } from "../server/session.ts";

const SCHEME = "scenec-rule";
const COMMAND = "scenec.explain";

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

function link(finding: vscode.Diagnostic): vscode.Diagnostic {
  if (typeof finding.code === "string") {
    const target = vscode.Uri.from({
      scheme: "command",
      path: COMMAND,
      query: JSON.stringify([finding.code]),
    });
    finding.code = { value: finding.code, target };
  }
  return finding;
}

/** Offers the pages, and the command that shows one. */
export function rulePages(session: Session): vscode.Disposable {
  const provider = vscode.workspace.registerTextDocumentContentProvider(SCHEME, {
    async provideTextDocumentContent(page) {
      const server = session.locate();
      if (!server.found) {
        return server.reason;
      }
      const rule = page.path.replace(/\.md$/, "");
      return (await promisify(execFile)(server.file, ["explain", rule])).stdout;
    },
  });
  const command = vscode.commands.registerCommand(COMMAND, async (code: unknown) => {
    if (typeof code === "string" && /^[A-Z]\d{3}$/.test(code)) {
      const page = vscode.Uri.from({ scheme: SCHEME, path: `${code}.md` });
      await vscode.commands.executeCommand("markdown.showPreviewToSide", page);
    }
  });
  return vscode.Disposable.from(provider, command);
}
