// The words of the status item.

import type { ServerStatus } from "./protocol.ts";

export interface Facts {
  server: "starting" | "running" | "down";
  reason?: string | undefined;
  version?: string | undefined;
  /** What the server says of its drawing process. */
  drawing?: ServerStatus;
}

/** The text of the item, and of the window that opens over it, as Markdown. */
export function label(facts: Facts): { short: string; long: string } {
  if (facts.server === "starting") {
    return { short: "$(loading~spin) scenec", long: "The server is starting." };
  }
  if (facts.server === "down") {
    return { short: "$(error) scenec", long: facts.reason ?? "The server is not running." };
  }
  const server = `scenec ${facts.version ?? ""}`.trim();
  const drawing = facts.drawing;
  if (drawing === undefined) {
    return { short: "scenec", long: server };
  }
  if (drawing.state === "down" || drawing.state === "restarting") {
    const why = drawing.message ?? "It ended by itself.";
    const what = drawing.state === "down" ? "There is no preview" : "The preview is starting anew";
    return { short: "$(warning) scenec", long: `${server}\n\n${what}: ${why}` };
  }
  const time = drawing.milliseconds === null ? undefined : duration(drawing.milliseconds);
  const parts = [drawing.device, time].filter(part => part !== null && part !== undefined);
  const last = time === undefined ? "" : `\n\nThe last picture took ${time}.`;
  const device = drawing.device === null ? "" : `\n\nRenders on: ${drawing.device}`;
  return { short: ["scenec", ...parts].join(" · "), long: `${server}${device}${last}` };
}

/** A time for people: `7.3 ms`, `250 ms`, `2.5 s`. */
export function duration(milliseconds: number): string {
  if (milliseconds < 10) {
    return `${milliseconds.toFixed(1)} ms`;
  }
  return milliseconds < 1000 ? `${milliseconds.toFixed(0)} ms` : `${(milliseconds / 1000).toFixed(1)} s`;
}
