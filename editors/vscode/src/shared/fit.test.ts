import assert from "node:assert/strict";
import { test } from "node:test";

import { fit, inPixels } from "./fit.ts";

test("a picture keeps its proportions", () => {
  assert.deepEqual(fit({ width: 600, height: 400 }, { width: 300, height: 1000 }), {
    width: 300,
    height: 200,
  });
  assert.deepEqual(fit({ width: 600, height: 400 }, { width: 3000, height: 200 }), {
    width: 300,
    height: 200,
  });
});

test("a picture grows as far as it may", () => {
  assert.deepEqual(fit({ width: 10, height: 10 }, { width: 100, height: 90 }), { width: 90, height: 90 });
  assert.deepEqual(fit({ width: 10, height: 10 }, { width: 100, height: 90 }, 2), { width: 20, height: 20 });
});

test("no room is still a pixel", () => {
  assert.deepEqual(fit({ width: 600, height: 400 }, { width: 0, height: 0 }), { width: 1, height: 1 });
  assert.deepEqual(inPixels({ width: 0, height: 10.4 }, 2), { width: 1, height: 21 });
});
