// How a picture lies in the room that it has.

export interface Size {
  width: number;
  height: number;
}

/** The largest size with the proportions of `picture` inside `room`; never larger than the picture times `most`. */
export function fit(picture: Size, room: Size, most = Number.POSITIVE_INFINITY): Size {
  const by = Math.min(room.width / picture.width, room.height / picture.height, most);
  return {
    width: Math.max(1, Math.floor(picture.width * by)),
    height: Math.max(1, Math.floor(picture.height * by)),
  };
}

/** The size of a place on the page in the screen's own pixels. */
export function inPixels(room: Size, ratio: number): Size {
  return {
    width: Math.max(1, Math.round(room.width * ratio)),
    height: Math.max(1, Math.round(room.height * ratio)),
  };
}
