// A window of the editor as a person works it: by mouse and keys, and by what is to be seen. Nothing here waits for a time to
// pass; everything waits for what it wants to see, and does again what a busy machine may have swallowed.

import assert from "node:assert/strict";

import type { FrameLocator, Locator, Page } from "playwright-core";

import { type Code, PATIENCE, shot } from "./code.ts";

/** After how long a key counts as swallowed, in milliseconds. */
const SWALLOWED = 15_000;

/** Writes into an input. It may close before that, as when something else takes the focus; whoever asked then does all of it again. */
export async function fill(input: Locator, text: string): Promise<void> {
  await input.fill(text, { timeout: SWALLOWED }).catch(() => undefined);
}

export class Window {
  readonly page: Page;
  readonly editor: Locator;

  private constructor(page: Page, file: string) {
    this.page = page;
    this.editor = page.locator(`.monaco-editor[data-uri$="${file}"]`).first();
  }

  /** A window with this file of the folder in its editor. */
  static async open(code: Code, file: string): Promise<Window> {
    const page = await code.open([["openFile", code.remote(`${code.folder}/${file}`)]]);
    const window = new Window(page, file);
    await window.editor.waitFor();
    return window;
  }

  /** The same window, with another file to look at. */
  at(file: string): Window {
    return new Window(this.page, file);
  }

  /** Keeps a picture of the window where a test failed. */
  async failed(context: object): Promise<void> {
    if ("passed" in context && !context.passed && "name" in context) {
      await shot(this.page, `failed ${String(context.name).slice(0, 40)}`);
    }
  }

  /** Asks until the answer is yes. */
  async until(what: string, ask: () => Promise<boolean>): Promise<void> {
    const end = Date.now() + PATIENCE;
    while (!(await ask())) {
      assert.ok(Date.now() < end, `timed out: ${what}`);
      await this.page.waitForTimeout(50);
    }
  }

  /** Does something until it shows; it must do no harm twice. */
  async again(act: () => Promise<void>, wanted: Locator): Promise<void> {
    await this.until("what was asked for", async () => {
      await act();
      return wanted.waitFor({ timeout: SWALLOWED }).then(
        () => true,
        () => false,
      );
    });
  }

  /** Presses a key until what it opens is there. */
  async press(key: string, opens: Locator): Promise<void> {
    await this.again(() => this.page.keyboard.press(key), opens);
  }

  /** The text on the screen, with plain spaces. */
  async text(): Promise<string> {
    const lines = await this.editor.locator(".view-line").evaluateAll(found =>
      found
        .map(line => ({ top: (line as HTMLElement).offsetTop, text: line.textContent ?? "" }))
        .sort((a, b) => a.top - b.top)
        .map(line => line.text),
    );
    return lines.join("\n").replaceAll("\u00a0", " ");
  }

  /** Runs a command by its name. */
  async run(command: string): Promise<void> {
    const input = this.page.locator(".quick-input-widget input:visible");
    const row = this.page.locator(".quick-input-list .monaco-list-row", { hasText: command }).first();
    // The list is made when it opens: a command whose time comes later is not in it.
    const list = async () => {
      await this.page.keyboard.press("Escape");
      await this.press("F1", input);
      await fill(input, `>${command}`);
    };
    await this.again(list, row);
    await row.click();
    await input.waitFor({ state: "hidden" });
  }

  /** Puts the cursor at a place, both counted from 1, and the focus into the text. */
  async go(line: number, column: number): Promise<void> {
    const input = this.page.locator(".quick-input-widget input:visible");
    await this.until(`the cursor at ${line}:${column}`, async () => {
      await this.press("Control+g", input);
      await fill(input, `:${line}:${column}`);
      await this.page.keyboard.press("Enter");
      const end = Date.now() + SWALLOWED;
      while (Date.now() < end) {
        if ((await this.position()).startsWith(`Ln ${line}, Col ${column}`) && (await this.#focused())) {
          return true;
        }
        await this.page.waitForTimeout(25);
      }
      return false;
    });
  }

  /** Where the cursor is, in the words of the status bar; empty while the focus is elsewhere. */
  async position(): Promise<string> {
    const found = await this.page.locator("#status\\.editor\\.selection").allTextContents();
    return found[0] ?? "";
  }

  token(words: string): Locator {
    return this.editor.locator(".view-line span > span").filter({ hasText: words }).first();
  }

  /** Rests the mouse on a word until the window over it has these words. */
  async hover(words: string, wanted: string): Promise<Locator> {
    const hover = this.page.locator(".monaco-hover:visible", { hasText: wanted });
    const rest = async () => {
      await this.page.mouse.move(0, 0);
      await this.token(words).hover();
    };
    await this.again(rest, hover);
    return hover;
  }

  /** The page inside the panel of the only preview. */
  preview(): FrameLocator {
    return this.page.frameLocator("iframe.webview.ready").frameLocator("#active-frame");
  }

  /** The page inside the panel of a file's preview, where there are several. */
  async previewOf(file: string): Promise<FrameLocator> {
    let found: FrameLocator | undefined;
    await this.until(`the preview of ${file}`, async () => {
      for (const outer of await this.page.locator("iframe.webview.ready").all()) {
        const inner = outer.contentFrame().frameLocator("#active-frame");
        if ((await inner.locator(`body[data-uri$="${file}"]`).count()) > 0) {
          found = inner;
        }
      }
      return found !== undefined;
    });
    assert.ok(found);
    return found;
  }

  /** A pixel of a preview's picture, as shares of its size. */
  pixel(x: number, y: number, preview = this.preview()): Promise<number[]> {
    return preview.locator("#picture").evaluate(
      (element, [x, y]) => {
        const canvas = element as HTMLCanvasElement;
        const [column, row] = [Math.floor(canvas.width * (x ?? 0)), Math.floor(canvas.height * (y ?? 0))];
        return [...(canvas.getContext("2d")?.getImageData(column, row, 1, 1).data ?? [])];
      },
      [x, y],
    );
  }

  /** Waits until the middle of a preview's picture has a colour. */
  async middle(what: string, is: (rgb: number[]) => boolean, preview = this.preview()): Promise<void> {
    await this.until(what, async () => is(await this.pixel(0.5, 0.5, preview)));
  }

  async #focused(): Promise<boolean> {
    const classes = await this.editor.getAttribute("class");
    return classes?.split(" ").includes("focused") ?? false;
  }
}

/** What a ball in the middle may look like. */
export const isRed = ([r = 0, g = 0, b = 0]: number[]): boolean => r > 100 && g < 40 && b < 40;
export const isBlue = ([r = 0, , b = 0]: number[]): boolean => b > 100 && r < 40;
export const isPale = ([r = 0, g = 0]: number[]): boolean => r > 70 && g > 70;
