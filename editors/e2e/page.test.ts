// What a person sees: the packaged extension in a window, worked by mouse and keys. The tests build on each other.

import assert from "node:assert/strict";
import { after, afterEach, before, test } from "node:test";

import type { FrameLocator, Locator, Page } from "playwright-core";

import { type Code, PATIENCE, shot, startCode } from "./code.ts";
import { BALL, HEAD } from "./scenes.ts";

let code: Code;
let page: Page;
let editor: Locator;

before(async () => {
  // Hints stand between the words of the text, where the tests look for words.
  code = await startCode(
    { "ball.scene": BALL },
    { "scenec.hints.fields": false, "scenec.hints.positions": false },
  );
  page = await code.open([["openFile", code.remote(`${code.folder}/ball.scene`)]]);
  editor = page.locator('.monaco-editor[data-uri$="ball.scene"]').first();
  await editor.waitFor();
});

afterEach(async context => {
  if ("passed" in context && !context.passed) {
    await shot(page, `failed ${context.name.slice(0, 40)}`);
  }
});

after(() => code?.close());

/** Asks until the answer is yes. */
async function until(what: string, ask: () => Promise<boolean>): Promise<void> {
  const end = Date.now() + PATIENCE;
  while (!(await ask())) {
    assert.ok(Date.now() < end, `timed out: ${what}`);
    await page.waitForTimeout(50);
  }
}

/** The text on the screen, with plain spaces. */
async function text(): Promise<string> {
  const lines = await editor.locator(".view-line").evaluateAll(found =>
    found
      .map(line => ({ top: (line as HTMLElement).offsetTop, text: line.textContent ?? "" }))
      .sort((a, b) => a.top - b.top)
      .map(line => line.text),
  );
  return lines.join("\n").replaceAll("\u00a0", " ");
}

async function run(command: string): Promise<void> {
  await page.keyboard.press("F1");
  await page.locator(".quick-input-widget input").fill(`>${command}`);
  await page.locator(".quick-input-list .monaco-list-row", { hasText: command }).first().click();
}

/** Puts the cursor at a place, both counted from 1, and the focus into the text. */
async function go(line: number, column: number): Promise<void> {
  await page.keyboard.press("Control+g");
  await page.locator(".quick-input-widget input").fill(`:${line}:${column}`);
  await page.keyboard.press("Enter");
  await until("the cursor", async () => (await position()).startsWith(`Ln ${line}, Col ${column}`));
}

async function position(): Promise<string> {
  // There is none while the focus is elsewhere.
  const found = await page.locator("#status\\.editor\\.selection").allTextContents();
  return found[0] ?? "";
}

function token(words: string): Locator {
  return editor.locator(".view-line span > span").filter({ hasText: words }).first();
}

/** The page inside the panel of the preview. */
function preview(): FrameLocator {
  return page.frameLocator("iframe.webview.ready").frameLocator("#active-frame");
}

/** What VS Code would open again in this folder, as it wrote it down: its groups of editors. */
function kept(): Promise<string> {
  return page.evaluate(async () => {
    const done = <T>(request: IDBRequest<T>) =>
      new Promise<T>((resolve, reject) => {
        request.onsuccess = () => resolve(request.result);
        request.onerror = () => reject(request.error);
      });
    let found = "";
    for (const { name } of await indexedDB.databases()) {
      if (name?.startsWith("vscode-web-state-db-")) {
        const database = await done(indexedDB.open(name));
        const items = database.transaction("ItemTable").objectStore("ItemTable");
        found += (await done(items.get("memento/workbench.parts.editor"))) ?? "";
        database.close();
      }
    }
    return found;
  });
}

/** A pixel of the preview's canvas, as shares of its size. */
function pixel(x: number, y: number, canvas = "#picture"): Promise<number[]> {
  return preview()
    .locator(canvas)
    .evaluate(
      (element, [x, y]) => {
        const canvas = element as HTMLCanvasElement;
        const [column, row] = [Math.floor(canvas.width * (x ?? 0)), Math.floor(canvas.height * (y ?? 0))];
        return [...(canvas.getContext("2d")?.getImageData(column, row, 1, 1).data ?? [])];
      },
      [x, y],
    );
}

async function isRed(): Promise<boolean> {
  const [r = 0, g = 0, b = 0] = await pixel(0.5, 0.5);
  return r > 100 && g < 40 && b < 40;
}

/** Whether the ball is where it is looked at, since it has its last colour. */
async function isPale(): Promise<boolean> {
  const [r = 0, g = 0] = await pixel(0.5, 0.5);
  return r > 70 && g > 70;
}

test("the language is named, and the words have colours", async () => {
  await page.locator("#status\\.editor\\.mode", { hasText: "Scene" }).waitFor();
  const words = editor.locator(".view-line span > span");
  await until("three colours", async () => {
    const found = await words.evaluateAll(words => words.map(word => getComputedStyle(word).color));
    return new Set(found).size >= 3;
  });
});

test("what does nothing is underlined and names the line that makes it so", async () => {
  await editor.locator(".squiggly-warning, .squiggly-unnecessary").first().waitFor({ state: "attached" });
  await run("Problems: Focus on Problems View");
  const problem = page.locator(".markers-panel .monaco-list-row", { hasText: "W005" });
  await problem.waitFor();
  const related = page.locator(".markers-panel .monaco-list-row", { hasText: "this is what is rendered" });
  await related.waitFor();
  await shot(page, "problems");
  await run("View: Toggle Problems");
  await problem.waitFor({ state: "hidden" });
});

test("a hover over a material tells its values and shows a ball of it", async () => {
  await token("red").hover();
  const hover = page.locator(".monaco-hover:visible", { hasText: "diffref" });
  await hover.waitFor();
  const ball = hover.locator('img[src^="data:image/png"]');
  await ball.waitFor();
  assert.ok(await ball.evaluate(image => (image as HTMLImageElement).naturalWidth >= 32));
  await shot(page, "hover");
  await page.keyboard.press("Escape");
});

test("the preview shows the picture", async () => {
  await run("Scene: Open Preview to the Side");
  await preview().locator("#picture").waitFor();
  await until("a red ball in the middle", isRed);
  const [r = 0, g = 0, b = 0] = await pixel(0.02, 0.02);
  assert.ok(Math.max(r, g, b) - Math.min(r, g, b) < 60, `the sky is ${[r, g, b]}`);
  await until("the device and the time", async () =>
    /cpu.*m?s/.test((await preview().locator("#facts").textContent()) ?? ""),
  );
});

test("an edit changes the picture", async () => {
  await go(HEAD + 1, 1);
  await page.keyboard.press("End");
  for (const key of [
    "Backspace",
    "Backspace",
    "Backspace",
    "Backspace",
    "Backspace",
    "0",
    " ",
    "0",
    " ",
    "1",
  ]) {
    await page.keyboard.press(key);
  }
  await until("a blue ball", async () => {
    const [r = 0, , b = 0] = await pixel(0.5, 0.5);
    return b > 100 && r < 40;
  });
});

test("a colour chosen at the swatch is written as numbers and seen in the picture", async () => {
  // The first one is the ambient light's.
  const swatch = editor.locator(".colorpicker-color-decoration").nth(1);
  await until("a blue swatch", async () => {
    const colour =
      (await swatch.count()) > 0 && (await swatch.evaluate(it => getComputedStyle(it).backgroundColor));
    return colour === "rgb(0, 0, 255)";
  });
  await swatch.click();
  const box = page.locator(".colorpicker-body .saturation-wrap:visible").first();
  await box.waitFor();
  await box.click({ position: { x: 3, y: 3 } });
  await shot(page, "swatch");
  await until("other numbers", async () => !(await text()).includes("20 0 0 1"));
  await until("a pale ball", isPale);
  await page.keyboard.press("Escape");
});

test("a click goes to the statement of what is seen", async () => {
  await preview().locator("#picture").click();
  await until("the statement", async () => (await position()).startsWith(`Ln ${HEAD + 2},`));
  assert.match(await position(), /15 selected/);
});

test("the object at the cursor is outlined", async () => {
  await go(HEAD + 2, 3);
  await until("an outline", () =>
    preview()
      .locator("#outline")
      .evaluate(element => {
        const canvas = element as HTMLCanvasElement;
        const data = canvas.getContext("2d")?.getImageData(0, 0, canvas.width, canvas.height).data ?? [];
        return data.some((value, index) => index % 4 === 3 && value > 0);
      }),
  );
  assert.match((await preview().locator("#object").textContent()) ?? "", /ball/);
  await shot(page, "outline");
});

test("a completion is accepted", async () => {
  await go(HEAD + 6, 1);
  await page.keyboard.press("End");
  await page.keyboard.type("\n!other := ");
  await page.keyboard.press("Control+Space");
  const row = page.locator(".suggest-widget:visible .monaco-list-row", { hasText: "sphere" }).first();
  await row.waitFor();
  await row.click();
  await until("the word", async () => (await text()).includes("!other := sphere"));
  await shot(page, "completion");
});

test("a name is renamed everywhere", async () => {
  await go(HEAD + 2, 3);
  await page.keyboard.press("F2");
  const input = page.locator(".rename-box input:visible");
  await input.waitFor();
  await input.fill("planet");
  await page.keyboard.press("Enter");
  await until("the new name", async () => ((await text()).match(/!planet/g) ?? []).length === 4);
});

test("a repair is taken from the menu", async () => {
  await go(HEAD + 5, 3);
  await page.keyboard.press("Control+.");
  const menu = page.locator(".action-widget:visible");
  await menu.waitFor();
  await shot(page, "repair");
  await menu
    .locator(".monaco-list-row.action", { hasText: /remove|delete/i })
    .first()
    .click();
  await until("the late edit is gone", async () => !(await text()).includes("+= 0 1 0"));
});

test("a broken text keeps the last picture and tells where it broke", async () => {
  await go(HEAD + 2, 1);
  await page.keyboard.press("End");
  await page.keyboard.type("oid");
  await preview().locator("body.stale").waitFor();
  await preview().locator("#trouble", { hasText: "sphereoid" }).waitFor();
  const [r = 0] = await pixel(0.5, 0.5);
  assert.ok(r > 100);
  await shot(page, "broken");
  await go(1, 1);
  await preview().locator("#trouble button").click();
  await until("the place", async () => (await position()).startsWith(`Ln ${HEAD + 2},`));
  await page.keyboard.press("Control+z");
  await preview().locator("body:not(.stale)").waitFor();
});

test("a drag walks around, and the camera is written to the file", async () => {
  const box = await preview().locator("#picture").boundingBox();
  assert.ok(box);
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 20, y + 10);
  await page.mouse.move(x + 80, y + 30);
  await page.mouse.up();
  await preview().locator("#write:enabled").click();
  await until("another camera", async () => !(await text()).includes("eyepos_z := 4"));
  await preview().locator("#write:disabled").waitFor();
});

test("keys move the view, and Home returns to the file's own", async () => {
  const canvas = preview().locator("#picture");
  await canvas.focus();
  for (let presses = 0; presses < 12; presses++) {
    await page.keyboard.press("Shift+ArrowRight");
  }
  await preview().locator("#reset:enabled").waitFor();
  await until("the ball at the side", async () => !(await isPale()));
  await page.keyboard.press("Home");
  await preview().locator("#reset:disabled").waitFor();
  await until("the ball in the middle", isPale);
});

test("the preview comes back when the window is loaded anew", async () => {
  await editor.locator(".view-line").first().click();
  await page.keyboard.press("Control+s");
  await until("a saved file", async () => (await page.locator(".tab.dirty").count()) === 0);
  // A window writes down what it shows every few seconds when it is idle, and nothing when it goes.
  const shown = /ball\.scene.*scenec\.preview.*camera[\\"]*:null/;
  await until("a window that is kept", async () => shown.test(await kept()));
  // Without the file to open that this window was started with, it shows what it showed before.
  const address = new URL(page.url());
  address.searchParams.delete("payload");
  await page.goto(address.href);
  await editor.waitFor();
  await preview().locator("#picture").waitFor();
  await until("the ball in the middle", isPale);
  await shot(page, "reloaded");
});
