// Where names stand beside what they name, without one on another.

/** A name: its middle, and half its width [px]. */
export interface Box {
  x: number;
  y: number;
  half: number;
}

/** What is kept of a name from one picture to the next. */
export interface Place {
  width: number; // px
  /** Which of the places it has. */
  last: number;
}

const tall = 16, gap = 6; // px
/** Places in the order in which they are tried: to the side (-1, 0, 1), and how far up or down [px]. */
const places: readonly [side: number, down: number][] = [[0, -18], [0, 18], [0, -36], [0, 36], [1, -18], [-1, -18], [1, 18], [-1, 18], [1, 0], [-1, 0], [1, -36], [-1, -36], [1, 36], [-1, 36], [0, -54], [0, 54], [0, -72], [0, 72]];

/** The place of a name at a point: the one that it had, if it is free, else the first free one; none where all are taken. */
export function placeLabel(label: Place, x: number, y: number, taken: readonly Box[], width: number, height: number): Box | undefined {
  const half = 0.5 * label.width;
  for (const index of [label.last, ...places.keys()]) {
    const [side, down] = places[index], box = {x: x + side * (half + gap + 6), y: y + down, half};
    if (!fits(box, taken, width, height)) continue;
    label.last = index;
    return box;
  }
  return undefined;
}

function fits({x, y, half}: Box, taken: readonly Box[], width: number, height: number): boolean {
  if (x < half + 2 || x > width - half - 2 || y < 0.5 * tall || y > height - 0.5 * tall) return false;
  return taken.every((other) => Math.abs(other.x - x) >= other.half + half + gap || Math.abs(other.y - y) >= tall);
}
