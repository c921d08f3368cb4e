// The page of a preview. It shows what the extension sends, and tells it what the hand does; the camera between two
// pictures is its own.

import type { Camera, View } from "../shared/camera.ts";
import { inPixels } from "../shared/fit.ts";
import type { PageState, ToExtension, ToPage } from "../shared/messages.ts";
import { duration } from "../statustext.ts";
import { listen } from "./gestures.ts";
import { Picture } from "./picture.ts";

const editor = acquireVsCodeApi<PageState>();
const tell = (message: ToExtension) => editor.postMessage(message);
const uri = document.body.dataset.uri ?? "";
const remembered = editor.getState();

const stage = element("stage", HTMLElement);
const canvas = element("picture", HTMLCanvasElement);
const trouble = element("trouble", HTMLElement);
const waiting = element("waiting", HTMLElement);
const facts = element("facts", HTMLElement);
const object = element("object", HTMLElement);
const reset = element("reset", HTMLButtonElement);
const write = element("write", HTMLButtonElement);
const picture = new Picture(
  stage,
  element("frame", HTMLElement),
  canvas,
  element("outline", HTMLCanvasElement),
);

/** The camera of the picture, or where the hand has moved it since. */
let view: View | undefined;

function element<T extends HTMLElement>(id: string, kind: new () => T): T {
  const found = document.getElementById(id);
  if (!(found instanceof kind)) {
    throw new Error(`the page has no ${id}`);
  }
  return found;
}

function remember(camera: Camera | null): void {
  editor.setState({ uri, camera });
  reset.disabled = camera === null;
  write.disabled = camera === null;
}

function toFileCamera(): void {
  remember(null);
  tell({ type: "camera", camera: null });
}

const hand = listen(canvas, {
  view: () => view,
  aspect: () => picture.aspect,
  moved(next) {
    view = next;
    const camera = { eye: next.eye, lookat: next.lookat };
    remember(camera);
    tell({ type: "camera", camera });
  },
  reset: toFileCamera,
  picked: (x, y) => tell({ type: "pick", x, y }),
});

function hear(message: ToPage): void {
  switch (message.type) {
    case "frame":
      waiting.hidden = true;
      void picture.show(message.png);
      break;
    case "picture":
      trouble.hidden = true;
      document.body.classList.remove("stale");
      facts.textContent = `${message.device} · ${duration(message.milliseconds)} · ${canvas.width} × ${canvas.height}`;
      // A picture from before the camera was moved may come after that; the next one tells where it is.
      if (!hand.held()) {
        view = message.camera ?? undefined;
        remember(message.moved && view !== undefined ? { eye: view.eye, lookat: view.lookat } : null);
      }
      break;
    case "trouble":
      document.body.classList.add("stale");
      waiting.hidden = true;
      trouble.hidden = false;
      trouble.querySelector("span")?.replaceChildren(message.message);
      trouble.querySelector("button")?.toggleAttribute("hidden", !message.place);
      break;
    case "outline":
      object.textContent = message.name;
      void picture.outline(message.png);
      break;
  }
}

canvas.setAttribute(
  "aria-label",
  `The picture of ${decodeURIComponent(uri.slice(uri.lastIndexOf("/") + 1))}`,
);
window.addEventListener("message", event => hear(event.data));
reset.addEventListener("click", toFileCamera);
write.addEventListener("click", () => tell({ type: "write" }));
trouble.querySelector("button")?.addEventListener("click", () => tell({ type: "goto" }));
new ResizeObserver(() => {
  picture.place();
  const room = { width: stage.clientWidth, height: stage.clientHeight };
  tell({ type: "room", size: inPixels(room, window.devicePixelRatio) });
}).observe(stage);
remember(remembered?.camera ?? null);
tell({ type: "ready", camera: remembered?.camera ?? null });
