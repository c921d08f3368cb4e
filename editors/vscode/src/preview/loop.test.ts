import assert from "node:assert/strict";
import { type TestContext, test } from "node:test";

import { DrawLoop } from "./loop.ts";

const PACE = { afterEdit: 30, whenIdle: 250 };

/** A loop whose pictures take `cost` milliseconds, and the notes on what it drew. */
function loop(context: TestContext, cost: number, full = true) {
  context.mock.timers.enable({ apis: ["setTimeout"] });
  const notes: string[] = [];
  const draw = (quality: string, signal: AbortSignal) => {
    notes.push(quality);
    return new Promise<boolean>(resolve => {
      const timer = setTimeout(() => {
        notes.push(`${quality} done`);
        resolve(true);
      }, cost);
      signal.addEventListener("abort", () => {
        clearTimeout(timer);
        notes.push(`${quality} cancelled`);
        resolve(false);
      });
    });
  };
  const wait = async (milliseconds: number) => {
    for (let i = 0; i < milliseconds; i++) {
      context.mock.timers.tick(1);
      await Promise.resolve();
      await Promise.resolve();
      await Promise.resolve();
    }
  };
  return { loop: new DrawLoop(draw, () => full, PACE), notes, wait };
}

test("an edit brings a draft soon and the full picture when idle", async context => {
  const { loop: it, notes, wait } = loop(context, 10);
  it.edited();
  await wait(29);
  assert.deepEqual(notes, []);
  await wait(12);
  assert.deepEqual(notes, ["draft", "draft done"]);
  await wait(300);
  assert.deepEqual(notes, ["draft", "draft done", "full", "full done"]);
  await wait(1000);
  assert.equal(notes.length, 4);
});

test("a burst of edits brings one draft, and each cancels what is under way", async context => {
  const { loop: it, notes, wait } = loop(context, 100);
  for (let i = 0; i < 5; i++) {
    it.edited();
    await wait(20);
  }
  assert.deepEqual(notes, []);
  await wait(50);
  it.edited();
  assert.deepEqual(notes, ["draft", "draft cancelled"]);
  await wait(140);
  assert.deepEqual(notes.slice(2), ["draft", "draft done"]);
});

test("what is saved is drawn at once and in full", async context => {
  const { loop: it, notes, wait } = loop(context, 100);
  it.saved();
  assert.deepEqual(notes, ["full"]);
  await wait(50);
  it.saved();
  await wait(1000);
  assert.deepEqual(notes, ["full", "full cancelled", "full", "full done"]);
});

test("a moving camera sees each draft to its end and skips what it can't keep up with", async context => {
  const { loop: it, notes, wait } = loop(context, 50);
  for (let i = 0; i < 20; i++) {
    it.moved();
    await wait(10);
  }
  await wait(60);
  assert.ok(!notes.some(note => note.includes("cancelled")), `${notes}`);
  const drafts = notes.filter(note => note === "draft").length;
  assert.ok(drafts >= 4 && drafts <= 6, `${notes}`);
});

test("a moving camera does not wait for a full picture", async context => {
  const { loop: it, notes, wait } = loop(context, 50);
  it.edited();
  await wait(30 + 50 + 250 + 10);
  it.moved();
  await wait(60);
  assert.deepEqual(notes.slice(2), ["full", "full cancelled", "draft", "draft done"]);
});

test("drafts only, where the settings say so; and nothing after the end", async context => {
  const { loop: it, notes, wait } = loop(context, 10, false);
  it.edited();
  await wait(1000);
  assert.deepEqual(notes, ["draft", "draft done"]);
  it.saved();
  await wait(1000);
  assert.deepEqual(notes.slice(2), ["draft", "draft done"]);
  it.edited();
  it.stop();
  await wait(1000);
  assert.equal(notes.length, 4);
});
