// Context for drawing marks: positions of values, and colours of the theme.

import type {Scale} from "./axis";
import {lineColor, type Palette, type Theme} from "./colors";
import type {Frame} from "./layout";
import type {PathPiece, Stroke} from "./pieces";
import type {Column, Line, Rows} from "./spec";

export type Point = readonly [x: number, y: number];

export interface Drawing {
  theme: Theme;
  palette: Palette;
  figureWidth: number;
  frame: Frame;
  /** Returns the position of a row [px]; NaN if it has none. */
  place(rows: Rows, row: number): Point;
  /** Returns the distance of a row from the eye; for axes in space. */
  depth?(rows: Rows, row: number): number;
}

/** Returns the function from values to positions in the plane. */
export function placeIn(frame: Frame, x: Scale, y: Scale) {
  return (atX: number | null | undefined, atY: number | null | undefined): Point => [
    frame.left + x.share(atX) * (frame.right - frame.left), frame.bottom - y.share(atY) * (frame.bottom - frame.top)];
}

export function strokeOf(line: Line | undefined, drawing: Drawing, color = line?.color): Stroke {
  const width = line?.width ?? 1.6, stroke: Stroke = {color: lineColor(color || "#111111", drawing.theme), width};
  if (line?.dash) stroke.dash = line.dash.map((length) => length * width);
  return stroke;
}

export const lengthOf = (rows: Rows) => (rows.x ?? rows.y ?? []).length;
export const numbers = (column: Column | undefined, count: number): Column => column ?? new Array<number>(count).fill(0);

/** Returns lines through positions; a NaN position interrupts the line. */
export function linesThrough(places: Iterable<Point>): number[][] {
  const lines: number[][] = [];
  let open: number[] | undefined;
  for (const [x, y] of places)
    if (Number.isFinite(x) && Number.isFinite(y)) {
      if (!open) lines.push((open = []));
      open.push(x, y);
    } else open = undefined;
  return lines;
}

export function* placesOf(rows: Rows, drawing: Drawing): Generator<Point> {
  for (let i = 0; i < lengthOf(rows); ++i) yield drawing.place(rows, i);
}

/** Returns a line in the colours of its values: contiguous pieces of one colour each. */
export function coloredLines(rows: Rows, line: Line | undefined, drawing: Drawing): PathPiece[] {
  const pieces: PathPiece[] = [];
  let step = -2, open: number[] = [], last: Point = [Number.NaN, Number.NaN];
  for (let i = 0; i < lengthOf(rows); ++i) {
    const at = drawing.place(rows, i), next = drawing.palette.step(rows.value?.[i]);
    if (i > 0 && Number.isFinite(last[0] + last[1] + at[0] + at[1]) && next >= 0) {
      if (next !== step || open.length === 0) {
        open = [last[0], last[1]];
        pieces.push({piece: "path", lines: [open], stroke: {...strokeOf(line, drawing), color: drawing.palette.all[next]!}});
      }
      open.push(at[0], at[1]);
    } else open = [];
    [step, last] = [next, at];
  }
  // In space near pieces cover far ones; a curve is drawn as a whole, from its farther end.
  const count = lengthOf(rows), isNear = drawing.depth && count > 1 && drawing.depth(rows, 0) < drawing.depth(rows, count - 1);
  return isNear ? pieces.reverse() : pieces;
}
