// The scenes that the tests open.

/** A scene of these statements, small enough to be traced in no time. */
export function scene(...statements: string[]): string {
  return `${[...SETTINGS, ...statements].join("\n")}\n`;
}

const SETTINGS = [
  "width := 120",
  "height := 80",
  "raydepth := 0",
  "lookat_x := 0",
  "lookat_y := 0",
  "lookat_z := 0",
  "eyepos_x := 0",
  "eyepos_y := 0",
  "eyepos_z := 4",
  "ambient_r := 0.1",
  "ambient_g := 0.1",
  "ambient_b := 0.1",
  "ambient_int_r := 0.2",
  "ambient_int_g := 0.2",
  "ambient_int_b := 0.2",
];

/** How many lines come before the statements. */
export const HEAD = SETTINGS.length;

/** A ball of a colour in the middle of the picture, so finely sampled that it takes its time. */
export function fine(colour: string): string {
  return scene(
    "samples := 256",
    `?paint := 0.5 0.5 0 0 0 1 20 ${colour}`,
    "!ball := sphere",
    "!ball ?= paint",
    "!ball <=",
    "*lamp := 0 0 9 1 1 1",
  );
}

/** A red ball in the middle of the picture, and an edit that comes too late. */
export const BALL = scene(
  "?red := 0.5 0.5 0 0 0 1 20 1 0 0",
  "!ball := sphere",
  "!ball ?= red",
  "!ball <=",
  "!ball += 0 1 0",
  "*lamp := 0 0 9 1 1 1",
);
