import assert from "node:assert/strict";
import { test } from "node:test";

import { Limit } from "./limit.ts";

test("a limit counts what happened lately", () => {
  const limit = new Limit(2, 1000);
  const times = [0, 10, 20, 999, 1000, 1005, 1010, 5000];
  assert.deepEqual(
    times.map(time => limit.allows(time)),
    [true, true, false, false, true, false, true, true],
  );
});
