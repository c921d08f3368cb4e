// From the hand to the camera: dragging, the wheel and the keys.

import { orbit, pan, type View, zoom } from "../shared/camera.ts";

/** What the hand does it to. */
export interface Subject {
  /** The camera of the picture; undefined before the first one. */
  view(): View | undefined;
  aspect(): number;
  moved(view: View): void;
  reset(): void;
  /** A click, from 0 to 1 from the upper left corner. */
  picked(x: number, y: number): void;
}

/** How far a finger may slip and still mean a click, in pixels. */
const SLIP = 4;
/** What one press of a key does, as a share of the picture. */
const STEP = 1 / 24;
const KEYS: Record<string, [number, number]> = {
  ArrowLeft: [-STEP, 0],
  ArrowRight: [STEP, 0],
  ArrowUp: [0, -STEP],
  ArrowDown: [0, STEP],
};

/** Listens on an element; `held` tells whether a drag is under way. */
export function listen(element: HTMLElement, subject: Subject): { held(): boolean } {
  let drag: { x: number; y: number; far: boolean } | undefined;
  const change = (make: (view: View) => View) => {
    const view = subject.view();
    if (view !== undefined) {
      subject.moved(make(view));
    }
  };
  const turn = (x: number, y: number, sideways: boolean) =>
    change(view => (sideways ? pan(view, x, y, subject.aspect()) : orbit(view, x, y)));

  element.addEventListener("pointerdown", event => {
    if (event.button === 0 || event.button === 1) {
      drag = { x: event.clientX, y: event.clientY, far: false };
      element.setPointerCapture(event.pointerId);
    }
  });
  element.addEventListener("pointermove", event => {
    if (drag === undefined) {
      return;
    }
    const [dx, dy] = [event.clientX - drag.x, event.clientY - drag.y];
    if (!drag.far && Math.hypot(dx, dy) < SLIP) {
      return;
    }
    const box = element.getBoundingClientRect();
    turn(dx / box.width, dy / box.height, event.shiftKey || (event.buttons & 4) !== 0);
    drag = { x: event.clientX, y: event.clientY, far: true };
  });
  element.addEventListener("pointerup", event => {
    const clicked = drag !== undefined && !drag.far && event.button === 0;
    drag = undefined;
    if (clicked) {
      const box = element.getBoundingClientRect();
      subject.picked((event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height);
    }
  });
  element.addEventListener("pointercancel", () => {
    drag = undefined;
  });
  element.addEventListener(
    "wheel",
    event => {
      event.preventDefault();
      const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? event.deltaY * 16 : event.deltaY;
      change(view => zoom(view, Math.exp(lines * 0.001)));
    },
    { passive: false },
  );
  element.addEventListener("keydown", event => {
    const step = KEYS[event.key];
    if (step !== undefined) {
      turn(step[0], step[1], event.shiftKey);
    } else if (event.key === "+" || event.key === "=") {
      change(view => zoom(view, 0.9));
    } else if (event.key === "-") {
      change(view => zoom(view, 1 / 0.9));
    } else if (event.key === "Home") {
      subject.reset();
    } else {
      return;
    }
    event.preventDefault();
  });
  return { held: () => drag?.far === true };
}
