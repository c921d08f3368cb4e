import assert from "node:assert/strict";
import { test } from "node:test";

import { orbit, pan, type Vector, type View, zoom } from "./camera.ts";

const FRONT: View = { eye: [0, 0, 5], lookat: [0, 0, 0], up: [0, 1, 0], fov: Math.PI / 2 };

function near(found: Vector, expect: Vector): void {
  found.forEach((x, i) => {
    assert.ok(Math.abs(x - (expect[i] ?? Number.NaN)) < 1e-9, `${found} is not ${expect}`);
  });
}

test("a movement to the right walks to the left", () => {
  near(orbit(FRONT, 0.5, 0).eye, [-5, 0, 0]);
  near(orbit(FRONT, -0.5, 0).eye, [5, 0, 0]);
  near(orbit(FRONT, 1, 0).eye, [0, 0, -5]);
});

test("a movement down rises, and stops before it is overhead", () => {
  const raised = orbit(FRONT, 0, 0.25).eye;
  near(raised, [0, 5 * Math.SQRT1_2, 5 * Math.SQRT1_2]);
  const top = orbit(FRONT, 0, 3);
  assert.ok(top.eye[1] > 4.99 && top.eye[2] > 0, `${top.eye}`);
  assert.deepEqual(orbit(top, 0, 1).eye.map(Math.round), [0, 5, 0]);
  assert.ok(orbit(FRONT, 0, -3).eye[1] < -4.99);
});

test("orbits keep the distance whatever is up", () => {
  for (const up of [
    [1, 0, 0],
    [0, 0, -2],
    [0.3, 2, -0.7],
  ] satisfies Vector[]) {
    const view: View = { eye: [3, 1, 2], lookat: [1, -1, 1], up, fov: 1 };
    const moved = orbit(view, 0.37, -0.21);
    assert.ok(Math.abs(Math.hypot(moved.eye[0] - 1, moved.eye[1] + 1, moved.eye[2] - 1) - 3) < 1e-9);
    assert.deepEqual(moved.lookat, view.lookat);
  }
});

test("an eye straight above does not break anything", () => {
  const above: View = { ...FRONT, eye: [0, 5, 0] };
  for (const moved of [orbit(above, 0.1, 0.1), pan(above, 0.1, 0.1, 1), zoom(above, 0.5)]) {
    assert.ok(moved.eye.every(Number.isFinite), `${moved.eye}`);
  }
});

test("panning by the whole width moves by what is seen at the point looked at", () => {
  const moved = pan(FRONT, 1, 0, 2);
  near(moved.eye, [-10, 0, 5]);
  near(moved.lookat, [-10, 0, 0]);
  near(pan(FRONT, 0, 1, 2).lookat, [0, 5, 0]);
});

test("zooming scales the distance and never arrives", () => {
  near(zoom(FRONT, 0.5).eye, [0, 0, 2.5]);
  near(zoom(FRONT, 2).eye, [0, 0, 10]);
  assert.ok(zoom(FRONT, 0).eye[2] > 0);
});
