// Extent of marks along the axes, for axes without a range.

import type {Column, Mark, Rows} from "./spec";

export type Extent = [low: number, high: number];
export type Along = "x" | "y" | "z" | "value";

const sum = (a: Column, b: Column, share: number): Column => a.map((one, i) => (one === null || b[i] == null ? null : one + share * b[i]!));
const ofRows = (rows: readonly Rows[], along: Along) => rows.map((one) => one[along] ?? []);

function columns(mark: Mark, along: Along): Column[] {
  switch (mark.mark) {
    case "line":
      return ofRows(mark.curves, along);
    case "surface":
      return ofRows(mark.lines, along);
    case "points":
      return ofRows([mark.rows], along);
    case "band":
      return along === "x" ? [mark.x] : along === "y" ? [mark.low, mark.high] : [];
    case "area":
      return along === "x" ? [mark.x] : along === "y" ? [mark.y] : [];
    case "boxes": {
      const half = 0.5 * (mark.width ?? 0.5);
      if (along === "x") return [mark.x.map((x) => (x ?? 0) - half), mark.x.map((x) => (x ?? 0) + half)];
      return along === "y" ? [mark.low_whisker, mark.high_whisker] : [];
    }
    case "rectangles":
      return along === "x" ? [mark.x_low, mark.x_high] : along === "y" ? [mark.y_low, mark.y_high] : (mark.value && along === "value" ? [mark.value] : []);
    case "image": {
      const {x = 0, y = 0, dx = 1, dy = 1} = mark;
      if (along === "x") return [[x - dx / 2, x + (mark.columns - 0.5) * dx]];
      return along === "y" ? [[y - dy / 2, y + (mark.rows - 0.5) * dy]] : along === "value" ? [mark.values] : [];
    }
    case "vectors": {
      const pivot = mark.pivot ?? 0;
      if (along === "x") return [sum(mark.x, mark.dx, -pivot), sum(mark.x, mark.dx, 1 - pivot)];
      return along === "y" ? [sum(mark.y, mark.dy, -pivot), sum(mark.y, mark.dy, 1 - pivot)] : (mark.value && along === "value" ? [mark.value] : []);
    }
    case "span":
      return along === "x" ? [[mark.low ?? 0, mark.high ?? 0]] : [];
  }
}

/** Returns the extent of the values above `floor`; [Infinity, -Infinity] if there are none. */
export function extentOf(marks: readonly Mark[], along: Along, floor = -Infinity): Extent {
  let low = Infinity, high = -Infinity;
  for (const mark of marks)
    for (const column of columns(mark, along))
      for (const value of column)
        if (value !== null && value > floor) {
          low = Math.min(low, value);
          high = Math.max(high, value);
        }
  return [low, high];
}
