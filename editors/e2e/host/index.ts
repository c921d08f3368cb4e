// Runs inside the editor's extension host: every test, one after the other, each with its own file. Writes a line of JSON
// for each to the file that SCENEC_RESULTS names.

import { appendFileSync } from "node:fs";

import * as actions from "./actions.ts";
import * as commands from "./commands.ts";
import * as language from "./language.ts";
import * as recovery from "./recovery.ts";

export async function run(): Promise<void> {
  const tests = { ...language.tests, ...actions.tests, ...commands.tests, ...recovery.tests };
  for (const [name, test] of Object.entries(tests)) {
    const start = Date.now();
    let error: string | undefined;
    try {
      await test();
    } catch (thrown) {
      error = thrown instanceof Error ? (thrown.stack ?? thrown.message) : String(thrown);
    }
    const result = { name, milliseconds: Date.now() - start, error };
    appendFileSync(process.env.SCENEC_RESULTS ?? "", `${JSON.stringify(result)}\n`);
  }
}
