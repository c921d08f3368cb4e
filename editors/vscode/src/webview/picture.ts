// The picture on the page: passes as they come, and the outline over it.

import { fit, type Size } from "../shared/fit.ts";

export class Picture {
  readonly #stage: HTMLElement;
  readonly #frame: HTMLElement;
  readonly #picture: HTMLCanvasElement;
  readonly #outline: HTMLCanvasElement;
  /** What is decoded comes later, and may be overtaken. */
  #newest = { picture: 0, outline: 0 };
  #size: Size | undefined;

  constructor(
    stage: HTMLElement,
    frame: HTMLElement,
    picture: HTMLCanvasElement,
    outline: HTMLCanvasElement,
  ) {
    this.#stage = stage;
    this.#frame = frame;
    this.#picture = picture;
    this.#outline = outline;
  }

  /** The proportions of what is shown, width over height. */
  get aspect(): number {
    return this.#size === undefined ? 1 : this.#size.width / this.#size.height;
  }

  /** What is shown, in the page's pixels. */
  get box(): DOMRect {
    return this.#picture.getBoundingClientRect();
  }

  /** Shows a pass. It fills the same place whatever its resolution. */
  async show(png: Uint8Array): Promise<void> {
    const image = await this.#decode(png, "picture");
    if (image !== undefined) {
      paint(this.#picture, image);
      this.#size = { width: this.#picture.width, height: this.#picture.height };
      this.#frame.hidden = false;
      this.place();
    }
  }

  /** Shows an outline, or none. */
  async outline(png: Uint8Array | null): Promise<void> {
    if (png === null) {
      this.#newest.outline++;
      this.#outline.getContext("2d")?.clearRect(0, 0, this.#outline.width, this.#outline.height);
      return;
    }
    const image = await this.#decode(png, "outline");
    if (image !== undefined) {
      paint(this.#outline, image);
    }
  }

  /** Fits the picture into its room. */
  place(): void {
    if (this.#size !== undefined) {
      const room = { width: this.#stage.clientWidth, height: this.#stage.clientHeight };
      const size = fit(this.#size, room);
      this.#frame.style.width = `${size.width}px`;
      this.#frame.style.height = `${size.height}px`;
    }
  }

  async #decode(png: Uint8Array, what: "picture" | "outline"): Promise<ImageBitmap | undefined> {
    const ticket = ++this.#newest[what];
    const image = await createImageBitmap(new Blob([new Uint8Array(png)], { type: "image/png" }));
    return ticket === this.#newest[what] ? image : undefined;
  }
}

function paint(canvas: HTMLCanvasElement, image: ImageBitmap): void {
  canvas.width = image.width;
  canvas.height = image.height;
  canvas.getContext("2d")?.drawImage(image, 0, 0);
  image.close();
}
