import {lineColor} from "./colors";
import {type Drawing, type Point, strokeOf} from "./drawing";
import type {Piece} from "./pieces";
import type {VectorsMark} from "./spec";

const back = (70 * Math.PI) / 180; // between the back edge of a head and its stroke

/** Returns a filled head with its tip at the end of a stroke. Unless fixed, it has at most half the length of the stroke, and is then wider. */
function headOf([x0, y0]: Point, [x1, y1]: Point, size: number, angle: number, isFixed: boolean): number[] {
  const far = Math.hypot(x1 - x0, y1 - y0) || 1e-9, [ux, uy] = [(x1 - x0) / far, (y1 - y0) / far];
  const length = isFixed ? size : Math.min(size, 0.5 * far), slope = (Math.tan(angle) * size) / length;
  const along = length / Math.hypot(1, slope), aside = slope * along, notch = along - (aside * length) / (size * Math.tan(back));
  const at = (u: number, v: number) => [x1 - u * ux - v * uy, y1 - u * uy + v * ux];
  return [x1, y1, ...at(along, aside), ...at(notch, 0), ...at(along, -aside)];
}

/** Returns strokes with their heads, grouped by colour. */
export function vectorPieces(mark: VectorsMark, drawing: Drawing, place: (x: number | null, y: number | null) => Point): Piece[] {
  const byColor = new Map<string, {strokes: number[][]; heads: number[][]}>(), own = mark.line?.color;
  const pivot = mark.pivot ?? 0, size = (mark.head ?? 0) * drawing.figureWidth, angle = ((mark.head_angle ?? 20) * Math.PI) / 180;
  for (let i = 0; i < mark.x.length; ++i) {
    const [x, y, dx, dy] = [mark.x[i], mark.y[i], mark.dx[i], mark.dy[i]];
    const color = own ? lineColor(own, drawing.theme) : drawing.palette.color(mark.value?.[i]);
    if (x == null || y == null || dx == null || dy == null || !color) continue;
    const [from, to] = [place(x - pivot * dx, y - pivot * dy), place(x + (1 - pivot) * dx, y + (1 - pivot) * dy)];
    const group = byColor.get(color) ?? {strokes: [], heads: []}, length = Math.hypot(to[0] - from[0], to[1] - from[1]);
    group.strokes.push([...from, ...to]);
    if (size > 0 && length > 0) group.heads.push(headOf(from, to, size, angle, mark.fixed_heads === true));
    byColor.set(color, group);
  }
  const stroke = strokeOf(mark.line, drawing);
  return [...byColor].flatMap(([color, {strokes, heads}]): Piece[] => [
    {piece: "path", lines: strokes, stroke: {...stroke, color}}, {piece: "path", lines: heads, closed: true, fill: color, stroke: {...stroke, color}}]);
}
