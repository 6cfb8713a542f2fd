// Placement of labels beside their points, without overlaps.

/** Label: its centre, and half its width [px]. */
export interface Box {
  x: number;
  y: number;
  half: number;
}

/** State of a label between two pictures. */
export interface Place {
  width: number; // px
  /** Index of its last place. */
  last: number;
}

const tall = 16, gap = 6; // px
/** Candidate places in order: side (-1, 0, 1), and vertical distance [px]. */
const places: readonly [side: number, down: number][] = [[0, -18], [0, 18], [0, -36], [0, 36], [1, -18], [-1, -18], [1, 18], [-1, 18], [1, 0], [-1, 0], [1, -36], [-1, -36], [1, 36], [-1, 36], [0, -54], [0, 54], [0, -72], [0, 72]];

/** Returns the place of a label at a point: its last one if that is free, else the first free one; undefined if all are taken. */
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
