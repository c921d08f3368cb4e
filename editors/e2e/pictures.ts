// Takes the pictures of the manual: `SCENEC_VSIX=FILE node pictures.ts`, and look at them before they are committed.

import path from "node:path";

import { startCode } from "./code.ts";

const PICTURES = path.join(import.meta.dirname, "../../docs/pictures");

/** Few statements that show much, and one that comes too late. */
const SCENE = `/ A ball, bitten
width := 640
height := 560
samples := 2
raydepth := 5
fov := 0.5
eyepos_x := 2.2
eyepos_y := 3.1
eyepos_z := 6
lookat_x := 0
lookat_y := 0.8
lookat_z := 0
ambient_r := 0.1
ambient_g := 0.22
ambient_b := 0.5
ambient_int_r := 0.75
ambient_int_g := 0.8
ambient_int_b := 0.95

?shell := 0.25 0.75 0.5 0.12 0 1 60 0.95 0.32 0.16
?flesh := 0.35 0.85 0.2 0 0 1 20 1 0.9 0.62
?floor := 0.2 0.35 0.3 0.3 0 1 40 0.25 0.3 0.45

!ball := sphere
!ball += 0 1 0
!ball ?= shell
!bite := sphere
!bite *= 0.85 0.85 0.85
!bite += 0.62 1.55 0.72
!bite ?= flesh
!bitten := ball - bite
!ground := hp
!ground ?= floor
!all := bitten | ground
!all <=
!ball += 0 1 0
*lamp := 3 8 9 1.25 1.2 1.1
`;

async function take(theme: string, name: string, hover: string | undefined): Promise<void> {
  const settings = {
    "breadcrumbs.enabled": false,
    "editor.fontSize": 12,
    "editor.lineNumbers": "on",
    "scenec.hints.fields": false,
    "workbench.activityBar.location": "hidden",
    "workbench.colorTheme": theme,
  };
  const code = await startCode({ "bitten.scene": SCENE }, settings);
  try {
    const page = await code.open([["openFile", code.remote(`${code.folder}/bitten.scene`)]]);
    const editor = page.locator('.monaco-editor[data-uri$="bitten.scene"]').first();
    await editor.waitFor();
    await page.keyboard.press("Control+b");
    await editor.locator(".squiggly-warning, .squiggly-unnecessary").first().waitFor({ state: "attached" });
    await editor.click();
    await page.keyboard.press("F1");
    await page.locator(".quick-input-widget input").fill(">Scene: Open Preview to the Side");
    await page.locator(".quick-input-list .monaco-list-row", { hasText: "Open Preview" }).first().click();
    const preview = page.frameLocator("iframe.webview.ready").frameLocator("#active-frame");
    await preview.locator("#facts", { hasText: / m?s / }).waitFor();
    await page.keyboard.press("Control+1");
    await page.keyboard.press("Control+g");
    await page.locator(".quick-input-widget input").fill(":25:3");
    await page.keyboard.press("Enter");
    await preview.locator("#object", { hasText: "ball" }).waitFor();
    if (hover !== undefined) {
      await editor.locator(".view-line span > span").filter({ hasText: hover }).first().hover();
      await page.locator(".monaco-hover:visible img").waitFor();
    }
    // The full picture comes a moment after the draft.
    await page.waitForTimeout(5000);
    await page.screenshot({ path: path.join(PICTURES, `${name}.png`), animations: "disabled" });
  } finally {
    await code.close();
  }
}

await take("Dark Modern", "editor-dark", undefined);
await take("Light Modern", "editor-light", "shell");
