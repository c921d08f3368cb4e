// What the two halves of a preview say to each other: the extension on one side, the page in the panel on the other.

import type { Camera, View } from "./camera.ts";
import type { Size } from "./fit.ts";

/** From the extension to the page. */
export type ToPage =
  /** A pass of a picture, from coarse to fine. */
  | { type: "frame"; png: Uint8Array }
  /** A picture is finished; `camera` is null where the file has none of its own. */
  | { type: "picture"; camera: View | null; device: string; milliseconds: number; moved: boolean }
  /** There is no new picture: the last one stays, dimmed. `place` says that there is a place to go to. */
  | { type: "trouble"; message: string; place: boolean }
  /** The outline of the object at the cursor, or none. */
  | { type: "outline"; png: Uint8Array | null; name: string };

/** From the page to the extension. */
export type ToExtension =
  /** The page listens; the camera is the one that it remembers from before a reload. */
  | { type: "ready"; camera: Camera | null }
  /** The room for the picture, in pixels of the screen. */
  | { type: "room"; size: Size }
  /** The camera was moved by hand; null goes back to the file's own. */
  | { type: "camera"; camera: Camera | null }
  /** The picture was clicked: from 0 to 1 from its upper left corner. */
  | { type: "pick"; x: number; y: number }
  /** The camera is to be written to the file. */
  | { type: "write" }
  /** The place of the trouble is wanted. */
  | { type: "goto" };

/** What the page remembers over a reload of the window. */
export interface PageState {
  uri: string;
  camera: Camera | null;
}
