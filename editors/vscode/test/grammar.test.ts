// The grammar as the editor reads it: which word gets which scope.

import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";
import { test } from "node:test";

import type * as Oniguruma from "vscode-oniguruma";
import type * as TextMate from "vscode-textmate";

const ROOT = path.join(import.meta.dirname, "..");
const require = createRequire(import.meta.url);
const { INITIAL, parseRawGrammar, Registry } = require("vscode-textmate") as typeof TextMate;
const oniguruma = require("vscode-oniguruma") as typeof Oniguruma;

const wasm = readFileSync(require.resolve("vscode-oniguruma/release/onig.wasm"));
await oniguruma.loadWASM(wasm.buffer.slice(wasm.byteOffset, wasm.byteOffset + wasm.byteLength));
const registry = new Registry({
  onigLib: Promise.resolve({
    createOnigScanner: patterns => new oniguruma.OnigScanner(patterns),
    createOnigString: text => new oniguruma.OnigString(text),
  }),
  loadGrammar: async () => {
    const file = path.join(ROOT, "syntaxes/scene.tmLanguage.json");
    return parseRawGrammar(readFileSync(file, "utf8"), file);
  },
});
const grammar = await registry.loadGrammar("source.scene");

/** The words of a line that have a scope of their own, as `word scope`, without the `.scene` at the end. */
function scopes(line: string): string[] {
  assert.ok(grammar);
  return grammar
    .tokenizeLine(line, INITIAL)
    .tokens.map(token => ({
      word: line.slice(token.startIndex, token.endIndex),
      scope: token.scopes.at(-1)?.replace(/\.scene$/, "") ?? "",
    }))
    .filter(({ word, scope }) => word.trim() !== "" && !/^(source|meta\.)/.test(scope))
    .map(({ word, scope }) => `${word} ${scope}`);
}

function check(line: string, ...expect: string[]): void {
  assert.deepEqual(scopes(line), expect, line);
}

const OBJECT = "entity.name.type.class.object";
const BANG = "! punctuation.definition.object";

test("objects and what is done to them", () => {
  check(
    "!ball := sphere",
    BANG,
    `ball ${OBJECT}`,
    ":= keyword.operator.object",
    "sphere keyword.control.base",
  );
  check(
    "!c:=a|b",
    BANG,
    `c ${OBJECT}`,
    ":= keyword.operator.object",
    `a ${OBJECT}`,
    "| keyword.operator.combination",
    `b ${OBJECT}`,
  );
  check(
    "!b ?= red",
    BANG,
    `b ${OBJECT}`,
    "?= keyword.operator.material-set",
    "red variable.other.enummember.material",
  );
  check("!b <=", BANG, `b ${OBJECT}`, "<= keyword.operator.submit");
  for (const axis of ["x", "y", "z"]) {
    check(
      `!b #${axis}= -pi`,
      BANG,
      `b ${OBJECT}`,
      `#${axis}= keyword.operator.rotate`,
      "- keyword.operator.sign",
      "pi constant.language.pi",
    );
  }
  check("!b #w= 1");
});

test("a base object's name is only a beginning", () => {
  check("!b := spheres", BANG, `b ${OBJECT}`, ":= keyword.operator.object", `spheres ${OBJECT}`);
});

test("values", () => {
  const head = ["x variable.other", ":= keyword.operator.variable"];
  for (const number of ["1", "2.", ".5", "6.02e23", "1E-3"]) {
    check(`x := ${number}`, ...head, `${number} constant.numeric`);
  }
  check("x := -.5", ...head, "- keyword.operator.sign", ".5 constant.numeric");
  check("x := 1.2.3", ...head, "1.2.3 invalid.illegal.number");
  check("x := 3abc", ...head, "3abc invalid.illegal.number");
  check("x := pie", ...head, "pie variable.other");
  check("x := ;", ...head, "; invalid.illegal");
});

test("settings are told from variables", () => {
  check(
    "width := 3",
    "width variable.other.property.setting",
    ":= keyword.operator.variable",
    "3 constant.numeric",
  );
  check("widths := 3", "widths variable.other", ":= keyword.operator.variable", "3 constant.numeric");
});

test("names take any letters", () => {
  check("!größe := hp", BANG, `größe ${OBJECT}`, ":= keyword.operator.object", "hp keyword.control.base");
  check("переменная := 1", "переменная variable.other", ":= keyword.operator.variable", "1 constant.numeric");
});

test("comments stand anywhere", () => {
  check("/ !ball := sphere", "/ !ball := sphere comment.line.slash");
  check("!b <=/ done", BANG, `b ${OBJECT}`, "<= keyword.operator.submit", "/ done comment.line.slash");
});

test("every statement of the scenes that come with the project is known, but for the broken ones", () => {
  const folder = path.join(ROOT, "../../scenes");
  for (const name of readdirSync(folder).filter(name => name.endsWith(".scene") && name !== "broken.scene")) {
    for (const line of readFileSync(path.join(folder, name), "utf8").split("\n")) {
      const found = scopes(line);
      assert.ok(line.trim() === "" || found.length > 0, `${name}: ${line}`);
      assert.ok(!found.some(scope => scope.includes("invalid")), `${name}: ${line}: ${found}`);
    }
  }
});
