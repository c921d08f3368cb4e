// One panel with the picture of one file. It asks the server for pictures and hands them to its page; when to ask is the
// loop's decision, how they look is the page's.

import * as vscode from "vscode";

import * as protocol from "../protocol.ts";
import type { Session } from "../server/session.ts";
import type { Camera, Vector } from "../shared/camera.ts";
import type { Size } from "../shared/fit.ts";
import type { ToExtension, ToPage } from "../shared/messages.ts";
import { DrawLoop } from "./loop.ts";
import { followsTyping, wantsFull } from "./mode.ts";
import { cursorIn, show } from "./places.ts";

export class Preview implements vscode.Disposable {
  readonly uri: vscode.Uri;
  readonly panel: vscode.WebviewPanel;
  readonly #session: Session;
  readonly #loop: DrawLoop;
  #camera: Camera | null = null;
  #room: Size | null = null;
  /** The page listens. It is made anew each time that its tab comes to the front. */
  #ready = false;
  #request = 0;
  #outlining: vscode.CancellationTokenSource | undefined;
  #trouble: vscode.Range | undefined;
  /** The last pass and the last words about it, for a page that is made anew. */
  #last: { frame?: ToPage; picture?: ToPage } = {};

  constructor(uri: vscode.Uri, panel: vscode.WebviewPanel, session: Session) {
    this.uri = uri;
    this.panel = panel;
    this.#session = session;
    this.#loop = new DrawLoop((quality, signal) => this.#draw(quality, signal), wantsFull);
    panel.webview.onDidReceiveMessage((message: ToExtension) => this.#hear(message));
    panel.onDidChangeViewState(() => this.#seen());
  }

  /** The text or a setting changed: a new picture is due. */
  changed(): void {
    this.#loop.edited();
  }

  /** The text was saved, where that is what the preview follows. */
  saved(): void {
    this.#loop.saved();
  }

  /** The cursor of the file's editor moved. */
  async outline(): Promise<void> {
    this.#outlining?.cancel();
    const position = cursorIn(this.uri);
    if (!this.#ready || position === undefined || this.#trouble !== undefined) {
      return;
    }
    const cancel = new vscode.CancellationTokenSource();
    this.#outlining = cancel;
    const params = { textDocument: this.#document(), position, size: this.#room, camera: this.#camera };
    const found = await this.#session.request(protocol.outline, params, cancel.token);
    if (!cancel.token.isCancellationRequested) {
      const png = found ? bytes(found.png) : null;
      this.#tell({ type: "outline", png, name: found?.name ?? "" });
    }
  }

  /** A pass of a picture came. */
  frame(frame: protocol.Frame): void {
    if (frame.id === this.#request) {
      this.#last.frame = { type: "frame", png: bytes(frame.png) };
      this.#tell(this.#last.frame);
    }
  }

  /** Back to the file's own camera. */
  reset(): void {
    this.#camera = null;
    this.#loop.moved();
  }

  /** Writes the camera of the panel to the file, as an edit that can be undone. */
  async write(): Promise<void> {
    if (this.#camera === null) {
      void vscode.window.showInformationMessage("Scene: the preview shows the camera of the file.");
      return;
    }
    const camera = { eye: short(this.#camera.eye), lookat: short(this.#camera.lookat) };
    const params = { textDocument: this.#document(), camera };
    const edit = await this.#session.request(protocol.writeCamera, params);
    const change = edit ? await this.#session.edit(edit) : undefined;
    if (change !== undefined && (await vscode.workspace.applyEdit(change))) {
      this.#camera = null;
      this.changed();
    } else {
      void vscode.window.showErrorMessage("Scene: the camera could not be written to the file.");
    }
  }

  dispose(): void {
    this.#loop.stop();
    this.#outlining?.cancel();
  }

  #document() {
    return { uri: this.#session.uri(this.uri) };
  }

  #tell(message: ToPage): void {
    if (this.#ready) {
      void this.panel.webview.postMessage(message);
    }
  }

  #seen(): void {
    if (!this.panel.visible) {
      this.#ready = false;
      this.#loop.stop();
    }
  }

  #hear(message: ToExtension): void {
    switch (message.type) {
      case "ready":
        this.#ready = true;
        this.#camera = message.camera;
        for (const remembered of [this.#last.frame, this.#last.picture]) {
          if (remembered !== undefined) {
            this.#tell(remembered);
          }
        }
        this.#loop.edited();
        break;
      case "room":
        this.#room = message.size;
        this.#loop.edited();
        break;
      case "camera":
        this.#camera = message.camera;
        this.#loop.moved();
        break;
      case "pick":
        void this.#pick(message.x, message.y);
        break;
      case "write":
        void this.write();
        break;
      case "goto":
        if (this.#trouble !== undefined) {
          void show(this.uri, this.#trouble);
        }
        break;
    }
  }

  async #pick(x: number, y: number): Promise<void> {
    const params = { textDocument: this.#document(), x, y, camera: this.#camera };
    const found = await this.#session.request(protocol.pick, params);
    if (found) {
      const { start, end } = found.range;
      await show(this.uri, new vscode.Range(start.line, start.character, end.line, end.character));
    }
  }

  async #draw(quality: protocol.Quality, signal: AbortSignal): Promise<boolean> {
    if (!this.#ready || this.#session.state.kind !== "running") {
      return false;
    }
    const cancel = new vscode.CancellationTokenSource();
    signal.addEventListener("abort", () => cancel.cancel());
    // The server knows the files that are open, so this one has to be.
    await vscode.workspace.openTextDocument(this.uri);
    const id = ++this.#request;
    const params = {
      textDocument: this.#document(),
      id,
      size: this.#room,
      camera: this.#camera,
      quality,
      despiteEdits: !followsTyping(),
    };
    const result = await this.#session.request(protocol.render, params, cancel.token);
    if (result === undefined || id !== this.#request || signal.aborted) {
      return false;
    }
    return this.#finish(result);
  }

  /** Tells the page how a picture ended; whether it is there. */
  #finish(result: protocol.RenderResult): boolean {
    if (result.outcome === "done") {
      this.#trouble = undefined;
      this.#last.picture = {
        type: "picture",
        camera: result.camera,
        device: result.device ?? "",
        milliseconds: result.milliseconds ?? 0,
        moved: this.#camera !== null,
      };
      this.#tell(this.#last.picture);
      void this.outline();
      return true;
    }
    if (result.outcome === "broken" || result.outcome === "failed") {
      const range = result.error?.range;
      this.#trouble = range
        ? new vscode.Range(range.start.line, range.start.character, range.end.line, range.end.character)
        : undefined;
      const message = result.error?.message ?? "There is no picture.";
      this.#tell({ type: "trouble", message, place: this.#trouble !== undefined });
    }
    return false;
  }
}

/** What base64 stands for. A plain array of bytes, since a message to a page can't hold a `Buffer`. */
function bytes(base64: string): Uint8Array {
  return new Uint8Array(Buffer.from(base64, "base64"));
}

/** Numbers that people read: a hand does not aim more finely. */
function short(place: Vector): Vector {
  const [x, y, z] = place.map(value => Number(value.toPrecision(5)));
  return [x ?? 0, y ?? 0, z ?? 0];
}
