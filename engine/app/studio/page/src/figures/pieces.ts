// Primitives of a picture, in pixels with y downwards. They are painted as SVG or on a canvas, and checked by tests.

export interface Stroke {
  color: string;
  width: number;
  dash?: readonly number[]; // [px]
  opacity?: number;
}

/** Separate polylines, each a list x0, y0, x1, y1, ... */
export interface PathPiece {
  piece: "path";
  lines: readonly ArrayLike<number>[];
  closed?: boolean;
  fill?: string;
  opacity?: number; // of the fill
  stroke?: Stroke;
}
/** Discs or rings of one style, at x0, y0, x1, y1, ... */
export interface DotsPiece {
  piece: "dots";
  at: ArrayLike<number>;
  radius: number;
  fill?: string;
  stroke?: Stroke;
}
export interface TextPiece {
  piece: "text";
  x: number;
  y: number; // base line
  text: string;
  size: number;
  color: string;
  anchor: "start" | "middle" | "end";
  angle?: number; // clockwise [degrees]
  rim?: string; // colour around the letters
}
/** Cells of equal size, row by row from the top; `pixels` has red, green, blue and opacity of each. */
export interface CellsPiece {
  piece: "cells";
  x: number;
  y: number;
  width: number;
  height: number;
  columns: number;
  rows: number;
  pixels: Uint8ClampedArray<ArrayBuffer>;
}
/** Rectangle with a vertical colour gradient. */
export interface GroundPiece {
  piece: "ground";
  x: number;
  y: number;
  width: number;
  height: number;
  radius: number;
  colors: readonly [string, string];
}
/** Highlight on a ball. */
export interface LightPiece {
  piece: "light";
  x: number;
  y: number;
  radius: number;
}
/** Pieces that are clipped to a rectangle. */
export interface ClippedPiece {
  piece: "clipped";
  x: number;
  y: number;
  width: number;
  height: number;
  pieces: readonly Piece[];
}
export type Piece = PathPiece | DotsPiece | TextPiece | CellsPiece | GroundPiece | LightPiece | ClippedPiece;

/** Returns the number of points of pieces, which decides between SVG and a canvas. */
export function pointCount(pieces: readonly Piece[]): number {
  let count = 0;
  for (const piece of pieces)
    if (piece.piece === "path") count += piece.lines.reduce((sum, line) => sum + line.length / 2, 0);
    else if (piece.piece === "dots") count += piece.at.length / 2;
    else if (piece.piece === "clipped") count += pointCount(piece.pieces);
    else count += 1;
  return count;
}
