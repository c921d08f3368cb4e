// The preview that follows what is saved, several previews at once, other themes, and what is left when the server gives up.
// The tests build on each other.

import assert from "node:assert/strict";
import { after, afterEach, before, test } from "node:test";

import { type Code, shot, startCode } from "./code.ts";
import { BALL, fine, HEAD } from "./scenes.ts";
import { fill, isBlue, isRed, Window } from "./window.ts";

const SETTINGS = {
  "scenec.hints.fields": false,
  "scenec.hints.positions": false,
  "scenec.preview.update": "onSave",
};
const isGreen = ([r = 0, g = 0, b = 0]: number[]) => g > 100 && r < 40 && b < 40;

let code: Code;
let window: Window;

before(async () => {
  code = await startCode({ "ball.scene": BALL, "fine.scene": fine("0 0 1") }, SETTINGS);
  window = await Window.open(code, "ball.scene");
});

afterEach(context => window?.failed(context));

after(() => code?.close());

/** Shows another file of the folder in front. */
async function show(file: string): Promise<Window> {
  const there = window.at(file);
  const tab = window.page.locator(`.tab[data-resource-name="${file}"]`).first();
  if ((await tab.count()) > 0) {
    await tab.click();
  } else {
    // In the group of the texts, and not over a picture.
    await window.page.keyboard.press("Control+1");
    const input = window.page.locator(".quick-input-widget input:visible");
    const row = window.page.locator(`.quick-input-list .monaco-list-row[aria-label^="${file}"]`).first();
    const list = async () => {
      await window.page.keyboard.press("Escape");
      await window.press("Control+p", input);
      await fill(input, file);
    };
    await window.again(list, row);
    await row.click();
  }
  await there.editor.waitFor();
  return there;
}

/** Replaces the three last values of a line, as many as there are digits and spaces. */
async function colour(there: Window, line: number, values: string): Promise<void> {
  await there.go(line, 1);
  await there.page.keyboard.press("End");
  for (const key of [..."12345"].map(() => "Backspace").concat([...values])) {
    await there.page.keyboard.press(key);
  }
}

/** Waits for a swatch, which tells that the server knows the text. */
async function swatch(there: Window, rgb: string): Promise<void> {
  const all = there.editor.locator(".colorpicker-color-decoration");
  await there.until(`a swatch ${rgb}`, async () => {
    const colours = await all.evaluateAll(found => found.map(it => getComputedStyle(it).backgroundColor));
    return colours.includes(rgb);
  });
}

test("a preview that follows what is saved waits for that", async () => {
  await window.run("Scene: Open Preview to the Side");
  await window.middle("a red ball", isRed);
  await colour(window, HEAD + 1, "0 0 1");
  await swatch(window, "rgb(0, 0, 255)");
  await window.middle("the ball is red still", isRed);
  await window.page.keyboard.press("Control+s");
  await window.middle("a blue ball", isBlue);
});

test("two files have their pictures beside each other", async () => {
  const other = await show("fine.scene");
  await other.run("Scene: Open Preview to the Side");
  await other.middle("a blue ball of the other file", isBlue, await other.previewOf("fine.scene"));
  const tab = (label: string) => window.page.locator(".tab", { hasText: label }).first();
  await tab("Preview ball.scene").click();
  await window.run("View: Move Editor into Next Group");
  const [first, second] = [await window.previewOf("ball.scene"), await window.previewOf("fine.scene")];
  await window.middle("the one", isBlue, first);
  await window.middle("the other", isBlue, second);
});

test("what is typed while a saved text is drawn does not stop its picture", async () => {
  const there = await show("fine.scene");
  const preview = await there.previewOf("fine.scene");
  const facts = () => preview.locator("#facts").textContent();
  await there.until("the first picture", async () => / m?s /.test((await facts()) ?? ""));
  const before = await facts();
  await colour(there, HEAD + 2, "0 1 0");
  await there.page.keyboard.press("Control+s");
  const dirty = there.page.locator(".tab.dirty", { hasText: "fine.scene" });
  await dirty.first().waitFor({ state: "detached" });
  await there.page.keyboard.type(" / late");
  await there.middle("a green ball", isGreen, preview);
  await there.until("the whole picture", async () => (await facts()) !== before);
  await dirty.first().waitFor();
  const red = await there.previewOf("ball.scene");
  await there.middle("the other picture is as it was", isBlue, red);
  await shot(there.page, "several");
});

for (const theme of ["Default High Contrast", "Default High Contrast Light"]) {
  test(`the preview in the theme ${theme}`, async () => {
    code.set({ ...SETTINGS, "workbench.colorTheme": theme });
    const preview = await window.previewOf("ball.scene");
    const kind = theme.endsWith("Light") ? "vscode-high-contrast-light" : "vscode-high-contrast";
    await preview.locator(`body.${kind}`).waitFor();
    // Every border that such a theme asks for is drawn.
    const border = await preview
      .locator("#write")
      .evaluate(it => [getComputedStyle(it).borderTopColor, getComputedStyle(it).backgroundColor]);
    assert.notEqual(border[0], "rgba(0, 0, 0, 0)");
    await window.middle("the picture", isBlue, preview);
    await shot(window.page, kind);
  });
}

/** Ends a process as soon as there is one. */
async function kill(there: Window, what: string, processes: () => number[]): Promise<void> {
  let one: number | undefined;
  await there.until(what, async () => {
    one = processes()[0];
    return one !== undefined;
  });
  process.kill(one ?? 0, "SIGKILL");
  await there.until(`its end: ${what}`, async () => !processes().includes(one ?? 0));
}

test("a drawing process that ends again and again is given up, and comes back with the server", async () => {
  const there = await show("ball.scene");
  await colour(there, HEAD + 1, "0 1 0");
  const [server] = code.servers();
  for (let ends = 0; ends < 5; ends++) {
    await kill(there, `drawing process ${ends + 1}`, code.drawers);
  }
  const item = there.page.locator('.statusbar-item[id$="scenec.status"]');
  const why = there.page.locator(".monaco-hover:visible", { hasText: "5 times in a row" });
  await there.again(async () => {
    await there.page.mouse.move(0, 0);
    await item.hover();
  }, why);
  await shot(there.page, "given up");
  // All else is as it was.
  assert.deepEqual(code.servers(), [server]);
  await swatch(there, "rgb(0, 255, 0)");
  await there.run("Scene: Restart the Server");
  await there.until("another server", async () => !code.servers().includes(server ?? 0));
  await there.page.keyboard.press("Control+s");
  await there.middle("a green ball", isGreen, await there.previewOf("ball.scene"));
});

test("a server that ends again and again is left alone, and snippets take its place", async () => {
  const there = await show("ball.scene");
  const drawn: number[] = [];
  for (let ends = 0; ends < 5; ends++) {
    // What draws has said its first words. Of one that ends while it says them the editor may start two.
    await there.until(`a picture of server ${ends + 1}`, async () =>
      code.drawers().some(drawer => !drawn.includes(drawer)),
    );
    drawn.push(...code.drawers());
    await kill(there, `server ${ends + 1}`, code.servers);
  }
  const message = there.page.locator(".notification-list-item", { hasText: "is left alone now" }).first();
  // A message goes out of sight after a while, and is kept behind the bell.
  await there.again(() => there.run("Notifications: Show Notifications"), message);
  await shot(there.page, "left alone");
  assert.deepEqual(code.servers(), []);
  assert.deepEqual(await offered(there), ["object"]);
  await there.run("Scene: Restart the Server");
  await there.until("a server", async () => code.servers().length === 1);
  await swatch(there, "rgb(0, 255, 0)");
  assert.deepEqual(await offered(there), ["!x := sphere"]);
});

/** What is offered at the end of the text to who types the word `object`. */
async function offered(there: Window): Promise<string[]> {
  await there.go(HEAD + 7, 1);
  await there.page.keyboard.type("objec");
  const widget = there.page.locator(".suggest-widget:visible");
  const rows = widget.locator(".monaco-list-row .label-name");
  await there.press("Control+Space", rows.first());
  const found = await rows.allTextContents();
  await there.page.keyboard.press("Escape");
  for (const key of [..."objec"].map(() => "Backspace")) {
    await there.page.keyboard.press(key);
  }
  return found;
}
