// Marks in the plane as pieces. Later marks cover earlier ones.

import {areaColor, lineColor} from "./colors";
import {coloredLines, type Drawing, lengthOf, linesThrough, placesOf, type Point, strokeOf} from "./drawing";
import type {DotsPiece, PathPiece, Piece} from "./pieces";
import type {AreaMark, BandMark, BoxesMark, Column, ImageMark, LineMark, Mark, PointsMark, RectanglesMark, Rows, SpanMark} from "./spec";
import {rgbOf} from "./colors";
import {vectorPieces} from "./vectors";

type XY = (x: number | null | undefined, y: number | null | undefined) => Point;

const isPlace = ([x, y]: Point) => Number.isFinite(x) && Number.isFinite(y);
const filled = (lines: number[][], fill: string, more: Partial<PathPiece> = {}): PathPiece => ({piece: "path", lines, closed: true, fill, ...more});

export function linePieces(mark: LineMark, drawing: Drawing): Piece[] {
  const pieces: Piece[] = [], hasColor = Boolean(mark.line?.color);
  for (const rows of mark.curves)
    if (hasColor) pieces.push({piece: "path", lines: linesThrough(placesOf(rows, drawing)), stroke: strokeOf(mark.line, drawing)});
    else pieces.push(...coloredLines(rows, mark.line, drawing));
  return mark.dots ? pieces.concat(dots(mark.curves, 0.5 * mark.dots, mark.line?.color, drawing)) : pieces;
}

/** Returns filled discs at rows, in one colour or in the colours of their values. */
function dots(curves: readonly Rows[], radius: number, color: string | undefined, drawing: Drawing): DotsPiece[] {
  const byColor = new Map<string, number[]>();
  for (const rows of curves)
    for (let i = 0; i < lengthOf(rows); ++i) {
      const at = drawing.place(rows, i), own = color ? lineColor(color, drawing.theme) : drawing.palette.color(rows.value?.[i]);
      if (!isPlace(at) || !own || !isInside(at, drawing)) continue;
      if (!byColor.has(own)) byColor.set(own, []);
      byColor.get(own)!.push(...at);
    }
  return [...byColor].map(([fill, at]) => ({piece: "dots", at, radius, fill}));
}

function isInside([x, y]: Point, {frame}: Drawing): boolean {
  return x >= frame.left - 0.5 && x <= frame.right + 0.5 && y >= frame.top - 0.5 && y <= frame.bottom + 0.5;
}

/** Returns a disc, ring or star at each row. */
export function pointPieces(mark: PointsMark, drawing: Drawing): Piece[] {
  const radius = 0.5 * (mark.size ?? 4);
  const discs = dots([mark.rows], radius, mark.color, drawing);
  if (mark.symbol === undefined || mark.symbol === "disc") return discs;
  return discs.map(({at, fill}) => symbolPiece(mark, at, radius, fill!));
}

export function symbolPiece(mark: PointsMark, at: ArrayLike<number>, radius: number, color: string): Piece {
  const stroke = {color, width: mark.width ?? 1};
  if (mark.symbol === "ring") return {piece: "dots", at, radius, stroke};
  if (mark.symbol !== "asterisk") return {piece: "dots", at, radius, fill: color};
  const lines: number[][] = [];
  for (let i = 0; i < at.length; i += 2)
    for (const [dx, dy] of [[1, 0], [0, 1], [1, 1], [1, -1]])
      lines.push([at[i]! - dx! * radius, at[i + 1]! - dy! * radius, at[i]! + dx! * radius, at[i + 1]! + dy! * radius]);
  return {piece: "path", lines, stroke};
}

function bandPieces({x, low, high, color, opacity}: BandMark, drawing: Drawing, place: XY): Piece[] {
  const lines: number[][] = [];
  let upper: number[] = [], lower: Point[] = [];
  const close = () => {
    if (upper.length > 2) lines.push([...upper, ...lower.reverse().flat()]);
    [upper, lower] = [[], []];
  };
  for (let i = 0; i < x.length; ++i) {
    const [above, below] = [place(x[i], high[i]), place(x[i], low[i])];
    if (isPlace(above) && isPlace(below)) {
      upper.push(...above);
      lower.push(below);
    } else close();
  }
  close();
  return [filled(lines, lineColor(color, drawing.theme), {opacity: opacity ?? 0.2})];
}

const areaPieces = ({x, y, color}: AreaMark, drawing: Drawing, place: XY): Piece[] =>
  [filled(linesThrough(x.map((_, i) => place(x[i], y[i]))), areaColor(color, drawing.theme))];

export function spanPieces({low = 0, high = 0, color}: SpanMark, drawing: Drawing, place: XY): Piece[] {
  const {top, bottom} = drawing.frame, [from] = place(low, 0), [to] = place(high, 0);
  return [filled([[from, top, to, top, to, bottom, from, bottom]], areaColor(color, drawing.theme))];
}

const rectangle = ([x0, y0]: Point, [x1, y1]: Point) => [x0, y0, x1, y0, x1, y1, x0, y1];

/** Returns the boxes of a box plot; the bars of whiskers are half as wide as the box. */
function boxPieces(mark: BoxesMark, drawing: Drawing, place: XY): Piece[] {
  const half = 0.5 * (mark.width ?? 0.5), boxes: number[][] = [], whiskers: number[][] = [];
  for (let i = 0; i < mark.x.length; ++i) {
    const x = mark.x[i] ?? Number.NaN, [lower, upper] = [mark.lower[i], mark.upper[i]];
    boxes.push(rectangle(place(x - half, lower), place(x + half, upper)));
    for (const [from, to] of [[lower, mark.low_whisker[i]], [upper, mark.high_whisker[i]]]) {
      whiskers.push([...place(x, from), ...place(x, to)], [...place(x - 0.5 * half, to), ...place(x + 0.5 * half, to)]);
    }
  }
  const stroke = {color: lineColor(mark.color, drawing.theme), width: 1.3}, known = (line: number[]) => line.every(Number.isFinite);
  return [filled(boxes.filter(known), stroke.color, {opacity: 0.2, stroke}), {piece: "path", lines: whiskers.filter(known), stroke}];
}

function rectanglePieces(mark: RectanglesMark, drawing: Drawing, place: XY): Piece[] {
  const byColor = new Map<string, number[][]>();
  for (let i = 0; i < mark.x_low.length; ++i) {
    const color = mark.color ? lineColor(mark.color, drawing.theme) : drawing.palette.color(mark.value?.[i]);
    const corners = rectangle(place(mark.x_low[i], mark.y_low[i]), place(mark.x_high[i], mark.y_high[i]));
    if (color && corners.every(Number.isFinite)) byColor.set(color, [...(byColor.get(color) ?? []), corners]);
  }
  const stroke = mark.edge ? {color: drawing.theme.dark ? drawing.theme.paper : mark.edge, width: 1} : undefined;
  return [...byColor].map(([fill, lines]) => filled(lines, fill, stroke && {stroke}));
}

/** Returns the pixels of cells from the highest row down; cells without a value are transparent. */
function pixelsOf(values: Column, columns: number, rows: number, drawing: Drawing): Uint8ClampedArray<ArrayBuffer> {
  const pixels = new Uint8ClampedArray(4 * columns * rows), colors = drawing.palette.all.map(rgbOf);
  for (let row = 0; row < rows; ++row)
    for (let column = 0; column < columns; ++column) {
      const color = colors[drawing.palette.step(values[(rows - 1 - row) * columns + column])];
      if (color) pixels.set([...color, 255], 4 * (row * columns + column));
    }
  return pixels;
}

function imagePieces({x = 0, y = 0, dx = 1, dy = 1, columns, rows, values}: ImageMark, drawing: Drawing, place: XY): Piece[] {
  const [left, top] = place(x - 0.5 * dx, y + (rows - 0.5) * dy), [right, bottom] = place(x + (columns - 0.5) * dx, y - 0.5 * dy);
  const size = {x: left, y: top, width: right - left, height: bottom - top};
  return [{piece: "cells", ...size, columns, rows, pixels: pixelsOf(values, columns, rows, drawing)}];
}

/** Returns the pieces of a mark; `place` maps values to positions. */
export function markPieces(mark: Mark, drawing: Drawing, place: XY): Piece[] {
  switch (mark.mark) {
    case "line":
      return linePieces(mark, drawing);
    case "points":
      return pointPieces(mark, drawing);
    case "band":
      return bandPieces(mark, drawing, place);
    case "area":
      return areaPieces(mark, drawing, place);
    case "boxes":
      return boxPieces(mark, drawing, place);
    case "rectangles":
      return rectanglePieces(mark, drawing, place);
    case "image":
      return imagePieces(mark, drawing, place);
    case "vectors":
      return vectorPieces(mark, drawing, place);
    case "span":
    case "surface":
      return []; // drawn behind the grid, and in space
  }
}
