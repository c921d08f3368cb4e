// What a person sees: the packaged extension in a window, worked by mouse and keys. The tests build on each other.

import assert from "node:assert/strict";
import { after, afterEach, before, test } from "node:test";

import { type Code, shot, startCode } from "./code.ts";
import { BALL, HEAD } from "./scenes.ts";
import { isBlue, isPale, isRed, Window } from "./window.ts";

let code: Code;
let window: Window;

before(async () => {
  // Hints stand between the words of the text, where the tests look for words.
  code = await startCode(
    { "ball.scene": BALL },
    { "scenec.hints.fields": false, "scenec.hints.positions": false },
  );
  window = await Window.open(code, "ball.scene");
});

afterEach(context => window?.failed(context));

after(() => code?.close());

/** What VS Code would open again in this folder, as it wrote it down: its groups of editors. */
function kept(): Promise<string> {
  return window.page.evaluate(async () => {
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

test("the language is named, and the words have colours", async () => {
  await window.page.locator("#status\\.editor\\.mode", { hasText: "Scene" }).waitFor();
  const words = window.editor.locator(".view-line span > span");
  await window.until("three colours", async () => {
    const found = await words.evaluateAll(words => words.map(word => getComputedStyle(word).color));
    return new Set(found).size >= 3;
  });
});

test("what does nothing is underlined and names the line that makes it so", async () => {
  await window.editor
    .locator(".squiggly-warning, .squiggly-unnecessary")
    .first()
    .waitFor({ state: "attached" });
  await window.run("Problems: Focus on Problems View");
  const problem = window.page.locator(".markers-panel .monaco-list-row", { hasText: "W005" });
  await problem.waitFor();
  const related = window.page.locator(".markers-panel .monaco-list-row", {
    hasText: "this is what is rendered",
  });
  await related.waitFor();
  await shot(window.page, "problems");
  await window.run("View: Toggle Problems");
  await problem.waitFor({ state: "hidden" });
});

test("a hover over a material tells its values and shows a ball of it", async () => {
  const hover = await window.hover("red", "diffref");
  const ball = hover.locator('img[src^="data:image/png"]');
  await ball.waitFor();
  assert.ok(await ball.evaluate(image => (image as HTMLImageElement).naturalWidth >= 32));
  await shot(window.page, "hover");
  await window.page.keyboard.press("Escape");
});

test("the preview shows the picture", async () => {
  await window.run("Scene: Open Preview to the Side");
  await window.preview().locator("#picture").waitFor();
  await window.middle("a red ball in the middle", isRed);
  const [r = 0, g = 0, b = 0] = await window.pixel(0.02, 0.02);
  assert.ok(Math.max(r, g, b) - Math.min(r, g, b) < 60, `the sky is ${[r, g, b]}`);
  await window.until("the device and the time", async () =>
    /cpu.*m?s/.test((await window.preview().locator("#facts").textContent()) ?? ""),
  );
});

test("an edit changes the picture", async () => {
  await window.go(HEAD + 1, 1);
  await window.page.keyboard.press("End");
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
    await window.page.keyboard.press(key);
  }
  await window.middle("a blue ball", isBlue);
});

test("a colour chosen at the swatch is written as numbers and seen in the picture", async () => {
  // The first one is the ambient light's.
  const swatch = window.editor.locator(".colorpicker-color-decoration").nth(1);
  await window.until("a blue swatch", async () => {
    const colour =
      (await swatch.count()) > 0 && (await swatch.evaluate(it => getComputedStyle(it).backgroundColor));
    return colour === "rgb(0, 0, 255)";
  });
  await swatch.click();
  const box = window.page.locator(".colorpicker-body .saturation-wrap:visible").first();
  await box.waitFor();
  await box.click({ position: { x: 3, y: 3 } });
  await shot(window.page, "swatch");
  await window.until("other numbers", async () => !(await window.text()).includes("20 0 0 1"));
  await window.middle("a pale ball", isPale);
  await window.page.keyboard.press("Escape");
});

test("a click goes to the statement of what is seen", async () => {
  await window.preview().locator("#picture").click();
  await window.until("the statement", async () => {
    const position = await window.position();
    return position.startsWith(`Ln ${HEAD + 2},`) && position.includes("15 selected");
  });
});

test("the object at the cursor is outlined", async () => {
  await window.go(HEAD + 2, 3);
  await window.until("an outline", () =>
    window
      .preview()
      .locator("#outline")
      .evaluate(element => {
        const canvas = element as HTMLCanvasElement;
        const data = canvas.getContext("2d")?.getImageData(0, 0, canvas.width, canvas.height).data ?? [];
        return data.some((value, index) => index % 4 === 3 && value > 0);
      }),
  );
  assert.match((await window.preview().locator("#object").textContent()) ?? "", /ball/);
  await shot(window.page, "outline");
});

test("a completion is accepted", async () => {
  await window.go(HEAD + 6, 1);
  await window.page.keyboard.press("End");
  await window.page.keyboard.type("\n!other := ");
  const row = window.page.locator(".suggest-widget:visible .monaco-list-row", { hasText: "sphere" }).first();
  await window.press("Control+Space", row);
  await row.click();
  await window.until("the word", async () => (await window.text()).includes("!other := sphere"));
  await shot(window.page, "completion");
});

test("a name is renamed everywhere", async () => {
  await window.go(HEAD + 2, 3);
  const input = window.page.locator(".rename-box input:visible");
  await window.press("F2", input);
  await input.fill("planet");
  await window.page.keyboard.press("Enter");
  await window.until(
    "the new name",
    async () => ((await window.text()).match(/!planet/g) ?? []).length === 4,
  );
});

test("a repair is taken from the menu", async () => {
  await window.go(HEAD + 5, 3);
  const menu = window.page.locator(".action-widget:visible");
  await window.press("Control+.", menu);
  await shot(window.page, "repair");
  await menu
    .locator(".monaco-list-row.action", { hasText: /remove|delete/i })
    .first()
    .click();
  await window.until("the late edit is gone", async () => !(await window.text()).includes("+= 0 1 0"));
});

test("a broken text keeps the last picture and tells where it broke", async () => {
  await window.go(HEAD + 2, 1);
  await window.page.keyboard.press("End");
  await window.page.keyboard.type("oid");
  await window.preview().locator("body.stale").waitFor();
  await window.preview().locator("#trouble", { hasText: "sphereoid" }).waitFor();
  const [r = 0] = await window.pixel(0.5, 0.5);
  assert.ok(r > 100);
  await shot(window.page, "broken");
  await window.go(1, 1);
  await window.preview().locator("#trouble button").click();
  await window.until("the place", async () => (await window.position()).startsWith(`Ln ${HEAD + 2},`));
  await window.page.keyboard.press("Control+z");
  await window.preview().locator("body:not(.stale)").waitFor();
});

test("a drag walks around, and the camera is written to the file", async () => {
  const box = await window.preview().locator("#picture").boundingBox();
  assert.ok(box);
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await window.page.mouse.move(x, y);
  await window.page.mouse.down();
  await window.page.mouse.move(x + 20, y + 10);
  await window.page.mouse.move(x + 80, y + 30);
  await window.page.mouse.up();
  await window.preview().locator("#write:enabled").click();
  await window.until("another camera", async () => !(await window.text()).includes("eyepos_z := 4"));
  await window.preview().locator("#write:disabled").waitFor();
});

test("keys move the view, and Home returns to the file's own", async () => {
  const canvas = window.preview().locator("#picture");
  for (let presses = 0; presses < 12; presses++) {
    await canvas.press("Shift+ArrowRight");
  }
  await window.preview().locator("#reset:enabled").waitFor();
  await window.middle("the ball at the side", rgb => !isPale(rgb));
  await canvas.press("Home");
  await window.preview().locator("#reset:disabled").waitFor();
  await window.middle("the ball in the middle", isPale);
});

test("the wheel comes nearer", async () => {
  const above = () => window.pixel(0.5, 0.27);
  assert.ok(!isPale(await above()), `above the ball is ${await above()}`);
  await window.preview().locator("#picture").hover();
  for (let turns = 0; turns < 4; turns++) {
    await window.page.mouse.wheel(0, -200);
  }
  await window.until("a ball that nearly fills the picture", async () => isPale(await above()));
  await window.preview().locator("#reset:enabled").click();
  await window.preview().locator("#reset:disabled").waitFor();
  await window.until("a ball with sky above it", async () => !isPale(await above()));
});

test("the preview comes back when the window is loaded anew", async () => {
  await window.editor.locator(".view-line").first().click();
  await window.page.keyboard.press("Control+s");
  await window.until("a saved file", async () => (await window.page.locator(".tab.dirty").count()) === 0);
  // A window writes down what it shows every few seconds when it is idle, and nothing when it goes.
  const shown = /ball\.scene.*scenec\.preview.*camera[\\"]*:null/;
  await window.until("a window that is kept", async () => shown.test(await kept()));
  // Without the file to open that this window was started with, it shows what it showed before.
  const address = new URL(window.page.url());
  address.searchParams.delete("payload");
  await window.page.goto(address.href);
  await window.editor.waitFor();
  await window.preview().locator("#picture").waitFor();
  await window.middle("the ball in the middle", isPale);
  await shot(window.page, "reloaded");
});
