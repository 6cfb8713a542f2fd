// Objects of a scene as pieces: for stills in a figure, and for the live scene.

import type {Piece, Stroke} from "./pieces";
import type {SceneStill, Shape} from "./spec";
import type {Theme} from "./colors";
import {fittedSize, textWidth} from "./text_size";

export interface SceneView {
  x: readonly [number, number]; // [m]
  y: readonly [number, number];
  background: string;
}

/** Position of a scene in the picture: its left upper corner, and pixels per metre. */
export interface Place {
  left: number;
  top: number;
  scale: number;
}

const leastLetters = 12; // px, in however small a view
const usual = 480; // px width of a scene in pictures

export const sceneHeight = ({x, y}: SceneView, width: number) => (width * (y[1] - y[0])) / (x[1] - x[0]);

function groundColors(background: string): readonly [string, string] {
  if (background === "dark") return ["#18222d", "#0a0f15"];
  return background === "light" ? ["#fbfcfd", "#e3e9ee"] : [background, background];
}

export function groundPiece(view: SceneView, {left, top, scale}: Place): Piece {
  const width = scale * (view.x[1] - view.x[0]);
  return {piece: "ground", x: left, y: top, width, height: sceneHeight(view, width), radius: 8, colors: groundColors(view.background)};
}

/** Layers of strokes that look like a round bar: dark edges and a light middle. Walls have the light middle only. */
const looks: Record<string, readonly [share: number, opacity: number, color: string][]> = {
  rod: [[1.25, 0.35, "#000000"], [1, 1, ""], [0.4, 0.45, "#ffffff"]],
  walls: [[1, 1, ""], [0.3, 0.35, "#ffffff"]],
  line: [[1, 1, ""]],
};

const strokeOf = (color: string, width: number, opacity: number): Stroke => (opacity === 1 ? {color, width} : {color, width, opacity});

/** Returns the piece of a text, reduced in size and moved so that none of it is cut off. */
function textPiece(shape: Shape, view: SceneView, place: Place, x: number, y: number): Piece {
  const text = shape.text ?? "", width = place.scale * (view.x[1] - view.x[0]), height = sceneHeight(view, width), edge = 4;
  const size = fittedSize(text, Math.max(leastLetters, place.scale * shape.size), width - 2 * edge), half = 0.5 * textWidth(text, size);
  const within = (value: number, low: number, high: number) => Math.max(low, Math.min(value, high));
  const at = {x: within(x, place.left + edge + half, place.left + width - edge - half), y: within(y, place.top + edge + size, place.top + height - edge - 0.25 * size)};
  return {piece: "text", ...at, text, size, color: shape.color, anchor: "middle"};
}

export function shapePieces(shape: Shape, view: SceneView, place: Place): Piece[] {
  if (!shape.shown || shape.points.length === 0) return [];
  const at = shape.points.flatMap(([x, y]) => [place.left + place.scale * (x - view.x[0]), place.top + place.scale * (view.y[1] - y)]);
  const width = place.scale * shape.width, radius = Math.max(0, place.scale * shape.size), {color} = shape;
  const look = looks[shape.kind];
  if (look)
    return look.map(([share, opacity, own]) => (
      {piece: "path", lines: [at], closed: shape.kind === "walls" && shape.closed !== false, stroke: strokeOf(own || color, width * share, opacity)}));
  if (shape.kind === "circle") return [{piece: "dots", at, radius, stroke: {color, width}}];
  if (shape.kind === "text") return [textPiece(shape, view, place, at[0]!, at[1]!)];
  const disc: Piece = {piece: "dots", at, radius, fill: color};
  if (shape.kind === "ball") return [disc, {piece: "light", x: at[0]!, y: at[1]!, radius}];
  return [disc, {piece: "dots", at, radius, stroke: {color: "#ffffff", width: 1.2}}];
}

const gap = 14, wordsHeight = 26, margin = 10;

/** Returns instants side by side, each with its caption below. */
export function stillPieces(still: SceneStill, title: string, theme: Theme): {pieces: Piece[]; width: number; height: number} {
  const count = still.instants.length, columns = count === 4 ? 2 : Math.min(3, Math.max(1, count)), height = sceneHeight(still, usual);
  const worded = still.instants.some(({words}) => words !== ""), cell = height + (worded ? wordsHeight : 0), top = title === "" ? margin : 34;
  const sheet = {width: 2 * margin + columns * (usual + gap) - gap, height: top + Math.ceil(count / columns) * (cell + gap) - gap + margin};
  const pieces = still.instants.flatMap(({words, shapes}, i): Piece[] => {
    const place = {left: margin + (i % columns) * (usual + gap), top: top + Math.floor(i / columns) * (cell + gap), scale: usual / (still.x[1] - still.x[0])};
    const size = fittedSize(words, 13, usual);
    const below: Piece[] = words === "" ? [] : [{piece: "text", x: place.left + 0.5 * usual, y: place.top + height + 18, text: words, size, color: theme.ticks, anchor: "middle"}];
    const inside = shapes.flatMap((shape) => shapePieces(shape, still, place));
    return [groundPiece(still, place), {piece: "clipped", x: place.left, y: place.top, width: usual, height, pieces: inside}, ...below];
  });
  const head: Piece[] = title === "" ? [] : [{piece: "text", x: 0.5 * sheet.width, y: 23, text: title, size: fittedSize(title, 15, sheet.width - 8), color: theme.ink, anchor: "middle"}];
  return {pieces: [...head, ...pieces], ...sheet};
}
