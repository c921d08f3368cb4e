// The page of a preview: one script and one style sheet of the extension's own, and nothing from elsewhere.

import { randomBytes } from "node:crypto";

import * as vscode from "vscode";

/** Writes the page into a panel. */
export function fill(webview: vscode.Webview, extension: vscode.Uri, uri: string): void {
  const file = (name: string) => webview.asWebviewUri(vscode.Uri.joinPath(extension, "dist", name));
  const nonce = randomBytes(16).toString("hex");
  const policy = `default-src 'none'; script-src 'nonce-${nonce}'; style-src ${webview.cspSource}`;
  webview.html = `<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${policy}">
<link rel="stylesheet" href="${file("preview.css")}">
<title>Preview</title>
</head>
<body data-uri="${escaped(uri)}">
<div id="trouble" role="status" hidden><span></span><button type="button">Go to it</button></div>
<main id="stage">
<div id="frame" hidden>
<canvas id="picture" tabindex="0" role="img" aria-describedby="keys"></canvas>
<canvas id="outline" aria-hidden="true"></canvas>
</div>
<p id="waiting">The picture is on its way.</p>
</main>
<p id="keys" hidden>Arrow keys walk around, with Shift they move sideways, plus and minus change the distance, Home returns
to the file's own camera. A click goes to the statement of what is under it.</p>
<footer>
<span id="facts" role="status"></span>
<span id="object"></span>
<button type="button" id="reset" disabled title="Return to the file's own camera (Home)">Reset</button>
<button type="button" id="write" disabled title="Write this camera to the file">Write Camera</button>
</footer>
<script nonce="${nonce}" src="${file("preview.js")}"></script>
</body>
</html>`;
}

function escaped(text: string): string {
  return text.replace(/[&<>"]/g, c => `&#${c.charCodeAt(0)};`);
}
