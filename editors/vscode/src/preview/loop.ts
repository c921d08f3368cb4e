// When a picture is drawn: soon after an edit, at once while the camera moves, in full quality when nothing happens any
// more. Knows only of time; what drawing means is its caller's matter.

import type { Quality } from "../protocol.ts";

export interface Pace {
  /** Milliseconds from an edit to the drawing. */
  afterEdit: number;
  /** Milliseconds without an event from a draft to the full picture. */
  whenIdle: number;
}

export const PACE: Pace = { afterEdit: 30, whenIdle: 250 };

/** Draws; says whether the picture was finished. The signal says that nobody waits for it any more. */
export type Draw = (quality: Quality, signal: AbortSignal) => Promise<boolean>;

export class DrawLoop {
  readonly #draw: Draw;
  readonly #wantsFull: () => boolean;
  readonly #pace: Pace;
  #timer: NodeJS.Timeout | undefined;
  #running: { quality: Quality; control: AbortController } | undefined;
  /** Whether the camera moved on while a draft was under way. */
  #again = false;

  constructor(draw: Draw, wantsFull: () => boolean, pace = PACE) {
    this.#draw = draw;
    this.#wantsFull = wantsFull;
    this.#pace = pace;
  }

  /** The text changed: what is being drawn is out of date. */
  edited(): void {
    this.#cancel();
    this.#later(this.#pace.afterEdit, "draft");
  }

  /** The text was saved, and is shown only then: nothing is to be waited for. */
  saved(): void {
    void this.#run(this.#wantsFull() ? "full" : "draft");
  }

  /** The camera moved: a draft under way is finished first, or a steady hand would never see one. */
  moved(): void {
    if (this.#running?.quality === "draft") {
      this.#again = true;
    } else {
      void this.#run("draft");
    }
  }

  /** Nothing is drawn any more until the next event. */
  stop(): void {
    this.#cancel();
    clearTimeout(this.#timer);
  }

  #cancel(): void {
    this.#running?.control.abort();
    this.#running = undefined;
    this.#again = false;
  }

  #later(delay: number, quality: Quality): void {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => void this.#run(quality), delay);
  }

  async #run(quality: Quality): Promise<void> {
    this.#cancel();
    clearTimeout(this.#timer);
    const run = { quality, control: new AbortController() };
    this.#running = run;
    const finished = await this.#draw(quality, run.control.signal).catch(() => false);
    if (this.#running !== run) {
      return;
    }
    this.#running = undefined;
    if (this.#again) {
      await this.#run("draft");
    } else if (finished && quality === "draft" && this.#wantsFull()) {
      this.#later(this.#pace.whenIdle, "full");
    }
  }
}
