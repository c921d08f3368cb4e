// The camera and how a hand moves it. Knows neither the editor nor the page: angles in radians, distances in the units of
// the scene, movements as shares of the picture's width and height.

export type Vector = [number, number, number];

/** Where the camera stands and what it looks at. */
export interface Camera {
  eye: Vector;
  lookat: Vector;
}

/** A camera with all that a picture needs of it. */
export interface View extends Camera {
  up: Vector;
  /** Horizontal field of view. */
  fov: number;
}

/** How far from straight up or down the camera stops, so that the picture never flips over. */
const POLE = 0.02;
/** The nearest that the eye comes to what it looks at. */
const NEAREST = 1e-3;

/** Walks around the point looked at: half a turn for a movement across the whole picture. */
export function orbit(view: View, right: number, down: number): View {
  const up = direction(view.up);
  const arm = minus(view.eye, view.lookat);
  const turned = rotate(arm, up, -right * Math.PI);
  const side = sideways(turned, view.up);
  const polar = Math.acos(clamp(dot(direction(turned), up), -1, 1));
  const wanted = clamp(polar - down * Math.PI, POLE, Math.PI - POLE);
  const raised = rotate(turned, side, wanted - polar);
  return { ...view, eye: plus(view.lookat, raised) };
}

/** Moves eye and point alike, so that the point looked at follows the hand. `aspect` is width over height. */
export function pan(view: View, right: number, down: number, aspect: number): View {
  const arm = minus(view.eye, view.lookat);
  const side = sideways(arm, view.up);
  const above = cross(direction(arm), side);
  const width = 2 * length(arm) * Math.tan(view.fov / 2);
  const step = plus(scale(side, -right * width), scale(above, (down * width) / aspect));
  return { ...view, eye: plus(view.eye, step), lookat: plus(view.lookat, step) };
}

/** Walks towards the point looked at (`factor` under 1) or away from it. */
export function zoom(view: View, factor: number): View {
  const arm = minus(view.eye, view.lookat);
  const reach = Math.max(length(arm) * factor, NEAREST);
  return { ...view, eye: plus(view.lookat, scale(direction(arm), reach)) };
}

/** To the right of a camera on this arm from the point looked at; any level way where the arm is parallel to `up`. */
function sideways(arm: Vector, up: Vector): Vector {
  const side = cross(up, arm);
  if (length(side) > 1e-9 * length(arm) * length(up)) {
    return direction(side);
  }
  const least = up.map(Math.abs).indexOf(Math.min(...up.map(Math.abs)));
  const axis: Vector = [0, 0, 0];
  axis[least] = 1;
  return direction(cross(axis, arm));
}

/** Rodrigues' formula (1840). */
function rotate(v: Vector, axis: Vector, angle: number): Vector {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const along = scale(axis, dot(axis, v) * (1 - c));
  return plus(plus(scale(v, c), scale(cross(axis, v), s)), along);
}

function plus(a: Vector, b: Vector): Vector {
  return [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
}

function minus(a: Vector, b: Vector): Vector {
  return plus(a, scale(b, -1));
}

function scale(a: Vector, by: number): Vector {
  return [a[0] * by, a[1] * by, a[2] * by];
}

function dot(a: Vector, b: Vector): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

function cross(a: Vector, b: Vector): Vector {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

function length(a: Vector): number {
  return Math.hypot(...a);
}

function direction(a: Vector): Vector {
  return scale(a, 1 / length(a));
}

function clamp(x: number, low: number, high: number): number {
  return Math.min(Math.max(x, low), high);
}
