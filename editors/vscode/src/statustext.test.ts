import assert from "node:assert/strict";
import { test } from "node:test";

import type { ServerStatus } from "./protocol.ts";
import { duration, type Facts, label } from "./statustext.ts";

const DRAWING: ServerStatus = { state: "ready", device: "cpu", milliseconds: 12.3, message: null };

function check(facts: Facts, short: string, long: RegExp): void {
  const found = label(facts);
  assert.equal(found.short, short);
  assert.match(found.long, long);
}

test("the item says how things stand", () => {
  check({ server: "starting" }, "$(loading~spin) scenec", /starting/);
  check({ server: "down", reason: "gone" }, "$(error) scenec", /gone/);
  check({ server: "running", version: "1.2" }, "scenec", /^scenec 1.2$/);
  check({ server: "running", drawing: DRAWING }, "scenec · cpu · 12 ms", /Renders on: cpu[\s\S]*12 ms/);
  check({ server: "running", drawing: { ...DRAWING, milliseconds: null } }, "scenec · cpu", /cpu$/);
  check(
    { server: "running", drawing: { ...DRAWING, state: "down", message: "no" } },
    "$(warning) scenec",
    /no$/,
  );
  check({ server: "running", drawing: { ...DRAWING, state: "restarting" } }, "$(warning) scenec", /anew/);
});

test("times are short", () => {
  assert.deepEqual([0.04, 7.26, 250.4, 2534].map(duration), ["0.0 ms", "7.3 ms", "250 ms", "2.5 s"]);
});
