// Axes and marks in space, in parallel projection. The box of the ranges is rotated by the azimuth about z, then tilted by the elevation,
// as in gnuplot.

import {type Scale, scaleOf} from "./axis";
import type {Theme} from "./colors";
import type {Drawing, Point} from "./drawing";
import {extentOf} from "./extent";
import type {Frame} from "./layout";
import type {Piece, TextPiece} from "./pieces";
import type {Box, Plot, Rows, SurfaceMark} from "./spec";

type Place3 = readonly [x: number, y: number, z: number];

export interface Space {
  scales: [Scale, Scale, Scale];
  /** Projects shares of the ranges, 0 to 1 each. */
  project(at: Place3): Point;
  depth(at: Place3): number; // grows with the distance from the eye
}

/** Half sides of the box as shares of the panel, across and up. */
const shares = {across: 0.26, up: 0.2415};
const radians = (degrees: number) => (degrees * Math.PI) / 180;

export function spaceOf(plot: Plot, [left, top, width, height]: Box): Space {
  const marks = plot.marks ?? [], axes = [plot.x ?? {}, plot.y ?? {}, plot.z ?? {}];
  const scales = (["x", "y", "z"] as const).map((along, i) => scaleOf(axes[i]!, extentOf(marks, along))) as Space["scales"];
  const spans = scales.map(({low, high}) => Math.abs(high - low) || 1), longest = Math.max(...spans);
  const sides = plot.equal ? spans.map((span) => span / longest) : [1, 1, 1];
  const [sx, sy] = plot.equal ? Array<number>(2).fill(Math.min(shares.across * width, shares.up * height)) : [shares.across * width, shares.up * height];
  const turn = radians(plot.view?.azimuth ?? 35), rise = radians(plot.view?.elevation ?? 62);
  const turned = (at: Place3): Place3 => {
    const [x, y, z] = at.map((one, i) => (2 * one - 1) * sides[i]!) as unknown as Place3;
    return [x * Math.cos(turn) + y * Math.sin(turn), y * Math.cos(turn) - x * Math.sin(turn), z];
  };
  const middle: Point = [left + 0.5 * width, top + 0.49 * height];
  const project = (at: Place3): Point => {
    const [across, away, up] = turned(at);
    return [middle[0] + sx! * across, middle[1] - sy! * (up * Math.sin(rise) + away * Math.cos(rise))];
  };
  const depth = (at: Place3) => {
    const [, away, up] = turned(at);
    return away * Math.sin(rise) - up * Math.cos(rise);
  };
  return {scales, project, depth};
}

export const sharesOf = ({scales: [x, y, z]}: Space, rows: Rows, i: number): Place3 =>
  [x.share(rows.x?.[i] ?? null), y.share(rows.y?.[i] ?? null), z.share(rows.z?.[i] ?? null)];

/** Returns the front edge of the floor for each axis, and the positions of the back walls. */
function sidesOf(space: Space) {
  const near = (axis: 0 | 1) => (space.depth(axis === 0 ? [0, 0.5, 0] : [0.5, 0, 0]) < space.depth(axis === 0 ? [1, 0.5, 0] : [0.5, 1, 0]) ? 0 : 1);
  const front = {x: near(0), y: near(1)};
  return {front, back: {x: 1 - front.x, y: 1 - front.y}};
}

const line = (space: Space, ...places: Place3[]) => places.flatMap((at) => [...space.project(at)]);

/** Returns the back walls and the floor, with their grid. */
export function boxPieces(space: Space, theme: Theme): Piece[] {
  const {front: f, back: b} = sidesOf(space), [x, y, z] = space.scales, grid: number[][] = [];
  for (const {at} of x.ticks) grid.push(line(space, [x.share(at), f.y, 0], [x.share(at), b.y, 0], [x.share(at), b.y, 1]));
  for (const {at} of y.ticks) grid.push(line(space, [f.x, y.share(at), 0], [b.x, y.share(at), 0], [b.x, y.share(at), 1]));
  for (const {at} of z.ticks) grid.push(line(space, [f.x, b.y, z.share(at)], [b.x, b.y, z.share(at)], [b.x, f.y, z.share(at)]));
  const edges = [
    line(space, [0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 0]), line(space, [f.x, b.y, 1], [b.x, b.y, 1], [b.x, f.y, 1]),
    line(space, [b.x, b.y, 0], [b.x, b.y, 1]), line(space, [f.x, b.y, 0], [f.x, b.y, 1]), line(space, [b.x, f.y, 0], [b.x, f.y, 1]),
  ];
  return [{piece: "path", lines: grid, stroke: {color: theme.grid, width: 0.8}}, {piece: "path", lines: edges, stroke: {color: theme.frame, width: 0.7, opacity: 0.7}}];
}

const size = 13;

/** Returns the labels of an axis along an edge of the box, on its outer side. */
function edgeTexts(space: Space, scale: Scale, at: (share: number) => Place3, theme: Theme): TextPiece[] {
  const [cx, cy] = space.project([0.5, 0.5, 0.5]), [ax, ay] = space.project(at(0)), [bx, by] = space.project(at(1));
  const length = Math.hypot(bx - ax, by - ay) || 1, side = Math.sign((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)) || 1;
  const out: Point = [(side * (by - ay)) / length, (-side * (bx - ax)) / length];
  const beside = Math.abs(out[0]) > 0.9, anchor = beside ? (out[0] > 0 ? "start" : "end") : "middle";
  const texts: TextPiece[] = scale.ticks.map(({at: value, label}) => {
    const [x, y] = space.project(at(scale.share(value)));
    return {piece: "text", x: x + (beside ? 12 : 17) * out[0], y: y + (beside ? 12 : 17) * out[1] + 4, text: label, size, color: theme.ticks, anchor};
  });
  if (scale.label === "") return texts;
  let angle = (Math.atan2(by - ay, bx - ax) * 180) / Math.PI;
  if (angle > 90 || angle <= -90) angle += 180;
  if (beside) angle = -90;
  const far = beside ? 58 : 42;
  return [...texts, {piece: "text", x: 0.5 * (ax + bx) + far * out[0], y: 0.5 * (ay + by) + far * out[1] + 4, text: scale.label, size, color: theme.ink, anchor: "middle", angle}];
}

export function spaceTexts(space: Space, theme: Theme): Piece[] {
  const {front: f, back: b} = sidesOf(space), [x, y, z] = space.scales;
  const corners: [number, number][] = [[f.x, b.y], [b.x, f.y]];
  const [ux, uy] = corners.sort((one, other) => space.project([...one, 0])[0] - space.project([...other, 0])[0])[0]!;
  return [
    ...edgeTexts(space, x, (share) => [share, f.y, 0], theme), ...edgeTexts(space, y, (share) => [f.x, share, 0], theme),
    ...edgeTexts(space, z, (share) => [ux, uy, share], theme),
  ];
}

/** Returns a surface as coloured quadrilaterals between successive lines, the far ones first. */
export function surfacePieces({lines}: SurfaceMark, space: Space, drawing: Drawing): Piece[] {
  const cells: {depth: number; fill: string; corners: number[]}[] = [];
  for (let i = 0; i + 1 < lines.length; ++i) {
    const [one, next] = [lines[i]!, lines[i + 1]!], count = Math.min(one.x?.length ?? 0, next.x?.length ?? 0);
    for (let k = 0; k + 1 < count; ++k) {
      const rows: [Rows, number][] = [[one, k], [one, k + 1], [next, k + 1], [next, k]], places = rows.map(([row, at]) => sharesOf(space, row, at));
      const values = rows.map(([row, at]) => (row.value ?? row.z)?.[at]).filter((value): value is number => value != null);
      const fill = drawing.palette.color(values.reduce((sum, value) => sum + value, 0) / values.length);
      const corners = places.flatMap((at) => [...space.project(at)]);
      if (fill && corners.every(Number.isFinite)) cells.push({fill, corners, depth: places.reduce((sum, at) => sum + space.depth(at), 0)});
    }
  }
  cells.sort((a, b) => b.depth - a.depth);
  // A stroke of the same colour closes the gaps that antialiasing leaves between neighbours.
  return cells.map(({fill, corners}) => ({piece: "path", lines: [corners], closed: true, fill, stroke: {color: fill, width: 0.6}}));
}

/** Returns the rectangle of the colour bar beside the box. */
export function barInSpace([left, top, width, height]: Box): Frame {
  return {left: left + 0.87 * width, right: left + 0.905 * width, top: top + 0.24 * height, bottom: top + 0.553 * height};
}
