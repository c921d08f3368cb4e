// The code of a finding is a link to the page of its rule, wherever a person meets it.

import { after, afterEach, before, test } from "node:test";

import type { Locator } from "playwright-core";

import { type Code, shot, startCode } from "./code.ts";
import { BALL } from "./scenes.ts";
import { Window } from "./window.ts";

let code: Code;
let window: Window;

before(async () => {
  code = await startCode({ "ball.scene": BALL });
  window = await Window.open(code, "ball.scene");
  const finding = window.editor.locator(".squiggly-warning, .squiggly-unnecessary").first();
  await finding.waitFor({ state: "attached" });
});

afterEach(context => window?.failed(context));

after(() => code?.close());

/** Follows a link to the page, which is shown as it reads, and closes it. */
async function follow(show: () => Promise<Locator>): Promise<void> {
  const heading = window.preview().locator("h1", { hasText: "W005: after-submission" });
  await window.again(async () => (await show()).click(), heading);
  await shot(window.page, "rule");
  await window.run("View: Close Editor");
  await heading.waitFor({ state: "detached" });
}

test("the code in a hover", async () => {
  await follow(async () => {
    const hover = await window.hover("+=", "W005");
    return hover.locator("a.code-link", { hasText: "W005" });
  });
});

test("the code in the list of problems", async () => {
  await follow(async () => {
    await window.run("Problems: Focus on Problems View");
    const problem = window.page.locator(".markers-panel .monaco-list-row", { hasText: "W005" });
    return problem.locator("a", { hasText: "W005" });
  });
});
