// The tests inside the extension host, each as a test of this run.

import assert from "node:assert/strict";
import path from "node:path";
import { test } from "node:test";

import { PATIENCE, startCode } from "./code.ts";

const HERE = import.meta.dirname;

test("inside the extension host", { timeout: 10 * PATIENCE }, async context => {
  const code = await startCode({});
  try {
    const log: string[] = [];
    const ended = new Promise<number>(resolve => {
      const payload: [string, string][] = [
        ["extensionDevelopmentPath", code.remote(path.join(HERE, "host/stub"))],
        ["extensionTestsPath", code.remote(path.join(HERE, "build/host.cjs"))],
        ["skipWelcome", "true"],
      ];
      void code.open(payload, async page => {
        await page.exposeFunction("codeAutomationLog", (type: string, args: unknown[]) => {
          log.push(`${type}: ${args.join(" ")}`);
        });
        await page.exposeFunction("codeAutomationExit", resolve);
      });
    });
    assert.equal(await ended, 0, log.join("\n"));
    for (const line of code.results()) {
      const result: { name: string; milliseconds: number; error?: string } = JSON.parse(line);
      await context.test(`${result.name} (${result.milliseconds} ms inside)`, () => {
        assert.equal(result.error, undefined);
      });
    }
  } finally {
    await code.close();
  }
});
