// What the language features answer through the editor's own programming interface.

import assert from "node:assert/strict";

import * as vscode from "vscode";

import { BALL, HEAD, scene } from "../scenes.ts";
import { ask, at, code, findings, open, replace, type Tests, until } from "./tools.ts";

function text(hover: vscode.Hover): string {
  return hover.contents.map(part => (typeof part === "string" ? part : part.value)).join("\n");
}

export const tests: Tests = {
  async "files of both extensions are scenes"() {
    for (const extension of ["scene", "rti"]) {
      const { document } = await open(BALL, extension);
      assert.equal(document.languageId, "scene");
    }
  },

  async "an edit that comes too late is reported with the line that submits, faded, and linked to its page"() {
    const { document } = await open(BALL);
    const [late] = await findings(document.uri, "W005", found => found.some(it => code(it) === "W005"));
    assert.ok(late);
    assert.equal(late.range.start.line, HEAD + 4);
    assert.equal(late.severity, vscode.DiagnosticSeverity.Warning);
    assert.deepEqual(late.tags, [vscode.DiagnosticTag.Unnecessary]);
    assert.equal(late.relatedInformation?.[0]?.location.range.start.line, HEAD + 3);
    assert.ok(typeof late.code === "object", `${late.code}`);
    const page = await vscode.workspace.openTextDocument(late.code.target);
    assert.match(page.getText(), /^# W005: after-submission\n/);
  },

  async "findings follow the text and are told once"() {
    const editor = await open(scene("!ball := shpere", "!ball <="));
    const { uri } = editor.document;
    const found = await findings(uri, "E008", found => found.some(it => code(it) === "E008"));
    assert.equal(found.filter(it => code(it) === "E008").length, 1);
    await replace(editor, "shpere", "sphere");
    await findings(uri, "no findings", found => found.length === 0);
    await replace(editor, "sphere", "cube");
    await findings(uri, "E008 again", found => found.some(it => code(it) === "E008"));
  },

  async "a hover names the ten values of a material"() {
    const { document } = await open(BALL);
    const hovers = await until("a hover", async () => {
      const found = await ask<vscode.Hover[]>(
        "vscode.executeHoverProvider",
        document.uri,
        at(document, "?red", 2),
      );
      return found.length > 0 && found;
    });
    const words = hovers.map(text).join("\n");
    for (const field of ["ambref", "diffref", "specref", "rflec", "rfrac", "rfracind", "shiny"]) {
      assert.ok(words.includes(field), `${field} in ${words}`);
    }
    assert.match(words, /data:image\/png;base64,/);
  },

  async "completion offers bases, objects and settings where they belong"() {
    const editor = await open(scene("!ball := sphere", "!ball <=", "!other := "));
    const { document } = editor;
    const offered = async (position: vscode.Position) => {
      const list = await ask<vscode.CompletionList>(
        "vscode.executeCompletionItemProvider",
        document.uri,
        position,
      );
      return list.items.map(item => (typeof item.label === "string" ? item.label : item.label.label));
    };
    const behind = at(document, "!other := ", "!other := ".length);
    const labels = await until("completions", async () => {
      const found = await offered(behind);
      return found.includes("sphere") && found;
    });
    assert.ok(
      labels.some(label => label.replace("!", "") === "ball"),
      `${labels}`,
    );
    const settings = await offered(new vscode.Position(document.lineCount - 1, 0));
    assert.ok(
      settings.some(label => label.includes("fov")),
      `${settings}`,
    );
  },

  async "signature help counts the values"() {
    const { document } = await open(BALL);
    const position = at(document, "?red := 0.5 0.5 ", "?red := 0.5 0.5 ".length);
    const help = await until("a signature", () =>
      ask<vscode.SignatureHelp | undefined>("vscode.executeSignatureHelpProvider", document.uri, position),
    );
    assert.equal(help.activeParameter, 2);
    assert.equal(help.signatures[0]?.parameters.length, 10);
  },

  async "colours are shown, and a changed one is three numbers"() {
    const { document } = await open(BALL);
    const colours = await until("colours", async () => {
      const found = await ask<vscode.ColorInformation[]>("vscode.executeDocumentColorProvider", document.uri);
      return found.length >= 2 && found;
    });
    const red = colours.find(it => it.range.start.line === HEAD);
    assert.ok(red);
    assert.equal(document.getText(red.range), "1 0 0");
    assert.deepEqual([red.color.red, red.color.green, red.color.blue], [1, 0, 0]);
    const [first] = await vscode.commands.executeCommand<vscode.ColorPresentation[]>(
      "vscode.executeColorPresentationProvider",
      new vscode.Color(0, 0.5, 1, 1),
      { uri: document.uri, range: red.range },
    );
    assert.equal(first?.textEdit?.newText ?? first?.label, "0 0.5 1");
  },

  async "hints name the values"() {
    const { document } = await open(BALL);
    const all = new vscode.Range(0, 0, document.lineCount, 0);
    const hints = await until("hints", async () => {
      const found = await ask<vscode.InlayHint[]>("vscode.executeInlayHintProvider", document.uri, all);
      return found.length > 0 && found;
    });
    const labels = hints.map(hint => (typeof hint.label === "string" ? hint.label : hint.label[0]?.value));
    assert.ok(
      labels.some(label => label?.includes("diffref")),
      `${labels}`,
    );
  },

  async "definition, references and highlights agree"() {
    const { document } = await open(BALL);
    const use = at(document, "!ball ?=", 2);
    const targets = await until("a definition", async () => {
      const found = await ask<(vscode.Location | vscode.LocationLink)[]>(
        "vscode.executeDefinitionProvider",
        document.uri,
        use,
      );
      return found.length > 0 && found;
    });
    const target = targets[0];
    assert.ok(target);
    const range = "targetRange" in target ? target.targetRange : target.range;
    assert.equal(range.start.line, HEAD + 1);
    const references = await ask<vscode.Location[]>("vscode.executeReferenceProvider", document.uri, use);
    const highlights = await ask<vscode.DocumentHighlight[]>(
      "vscode.executeDocumentHighlights",
      document.uri,
      use,
    );
    assert.equal(references.length, 4);
    assert.equal(highlights.length, 4);
  },

  async "the outline begins with what is submitted"() {
    const { document } = await open(BALL);
    const symbols = await until("symbols", async () => {
      const found = await ask<vscode.DocumentSymbol[] | undefined>(
        "vscode.executeDocumentSymbolProvider",
        document.uri,
      );
      return found !== undefined && found.length > 0 && found;
    });
    const names = symbols.map(symbol => symbol.name.replace(/^[!?*]/, ""));
    assert.ok(names.includes("ball") && names.includes("red"), `${names}`);
  },

  async "words have meanings beyond the grammar"() {
    const { document } = await open(BALL);
    const tokens = await until("tokens", () =>
      ask<vscode.SemanticTokens | undefined>("vscode.provideDocumentSemanticTokens", document.uri),
    );
    assert.ok(tokens.data.length > 50, `${tokens.data.length}`);
  },

  async "selections grow and objects fold"() {
    const { document } = await open(BALL);
    const [selection] = await until("selections", async () => {
      const found = await ask<vscode.SelectionRange[]>("vscode.executeSelectionRangeProvider", document.uri, [
        at(document, "0.5"),
      ]);
      return found.length > 0 && found;
    });
    assert.ok(selection?.parent?.range.contains(selection.range));
    const folds = await ask<vscode.FoldingRange[]>("vscode.executeFoldingRangeProvider", document.uri);
    assert.ok(folds.length > 0);
  },
};
