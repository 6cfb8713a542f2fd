// Legend of the marks that have an entry, above or beside the axes.

import {lineColor} from "./colors";
import {type Drawing, strokeOf} from "./drawing";
import {gaps, rowHeight} from "./layout";
import {symbolPiece} from "./marks";
import type {Piece} from "./pieces";
import type {Mark, Plot} from "./spec";
import {textWidth} from "./text_size";

const size = 12, sample = 30, gap = 8, between = 22;

export type LegendMark = Mark & {legend: string};

export const entriesOf = (plot: Plot): LegendMark[] =>
  plot.legend === undefined || plot.legend === "none" ? [] : (plot.marks ?? []).filter((mark): mark is LegendMark => "legend" in mark && Boolean(mark.legend));

const sampleWidth = (entries: readonly Mark[]) => (entries.every((mark) => mark.mark === "rectangles") ? 14 : sample);

/** Arranges entries in rows of at most `room` [px], with equal column widths. */
export function legendRows(entries: readonly LegendMark[], room: number): LegendMark[][] {
  if (entries.length === 0) return [];
  const widest = columnWidth(entries), columns = Math.max(1, Math.min(entries.length, Math.floor((room + between) / widest)));
  return Array.from({length: Math.ceil(entries.length / columns)}, (_, i) => entries.slice(i * columns, (i + 1) * columns));
}

const columnWidth = (entries: readonly LegendMark[]) =>
  sampleWidth(entries) + gap + between + Math.max(0, ...entries.map(({legend}) => textWidth(legend, size)));

/** Returns the sample beside the words of an entry, from `x` over `width` pixels, centred at `y`. */
function samplePieces(mark: LegendMark, x: number, y: number, width: number, drawing: Drawing): Piece[] {
  const line = [x, y, x + width, y], middle = [x + 0.5 * width, y];
  if (mark.mark === "line") {
    const pieces: Piece[] = [{piece: "path", lines: [line], stroke: strokeOf(mark.line, drawing)}];
    const fill = lineColor(mark.line?.color || "#111111", drawing.theme);
    return mark.dots ? [...pieces, {piece: "dots", at: middle, radius: 0.5 * mark.dots, fill}] : pieces;
  }
  if (mark.mark === "vectors") return [{piece: "path", lines: [line], stroke: strokeOf(mark.line, drawing)}];
  const color = lineColor("color" in mark && mark.color ? mark.color : "#111111", drawing.theme);
  if (mark.mark === "points") return [symbolPiece(mark, middle, 0.5 * (mark.size ?? 4), color)];
  const box = [x, y - 5, x + width, y - 5, x + width, y + 5, x, y + 5];
  return [{piece: "path", lines: [box], closed: true, fill: color, ...(mark.mark === "boxes" ? {opacity: 0.2, stroke: {color, width: 1.3}} : {})}];
}

/** Positions the entries: above the frame in centred rows, or beside it in one column. */
export function legendPieces(plot: Plot, rows: readonly LegendMark[][], drawing: Drawing, top: number): Piece[] {
  const pieces: Piece[] = [], all = rows.flat(), step = columnWidth(all), wide = sampleWidth(all), {frame, theme} = drawing;
  const put = (mark: LegendMark, x: number, base: number) => pieces.push(...samplePieces(mark, x, base - gaps.base, wide, drawing),
    {piece: "text", x: x + wide + gap, y: base, text: mark.legend, size, color: theme.ticks, anchor: "start"});
  if (plot.legend === "above")
    rows.forEach((row, r) => {
      const left = 0.5 * (frame.left + frame.right) - 0.5 * (step * rows[0]!.length - between);
      row.forEach((mark, i) => put(mark, left + i * step, top + rowHeight * r));
    });
  else all.forEach((mark, i) => put(mark, frame.right + 26, 0.5 * (frame.top + frame.bottom) + rowHeight * (i - 0.5 * (all.length - 1)) + gaps.base));
  return pieces;
}

