// Panel with axes as three layers: background, marks and foreground, so that many marks can be painted on a canvas.

import {axisPieces, colorBar, gridPieces} from "./axes";
import {type Scale, scaleOf} from "./axis";
import {Palette, textColor, type Theme} from "./colors";
import {type Drawing, placeIn} from "./drawing";
import {extentOf} from "./extent";
import {type Frame, frameOf, gaps, titleRows} from "./layout";
import {entriesOf, type LegendMark, legendPieces, legendRows} from "./legend";
import {linePieces, markPieces, pointPieces, spanPieces} from "./marks";
import type {Piece} from "./pieces";
import {barInSpace, boxPieces, sharesOf, spaceOf, spaceTexts, surfacePieces} from "./space";
import type {Box, Mark, Plot, SpanMark} from "./spec";
import {fittedSize, textWidth, wrapped} from "./text_size";
import {textPieces} from "./texts";

export interface Layers {
  back: Piece[];
  marks: Piece[];
  front: Piece[];
}

/** Properties of the whole figure that a panel needs. */
export interface Sheet {
  width: number;
  height: number;
  aligned: boolean;
  anyColor: boolean;
  theme: Theme;
}

interface Colors {
  scale?: Scale;
  palette: Palette;
}

function colorsOf(plot: Plot): Colors {
  if (!plot.color) return {palette: new Palette(plot.palette ?? [])};
  const [low, high] = extentOf(plot.marks ?? [], "value"), scale = scaleOf(plot.color, low <= high ? [low, high] : extentOf(plot.marks ?? [], "z"));
  return {scale, palette: new Palette(plot.palette ?? [], scale.low, scale.high)};
}

/** Returns the title of a panel above its axes; a long one is smaller or has two lines. */
function titlePieces(plot: Plot, box: Box, frame: {left: number; right: number; top: number}, theme: Theme): Piece[] {
  const title = plot.title ?? "", room = box[2] - 70;
  if (title === "") return [];
  const lines = textWidth(title, 11) > room ? wrapped(title, 13, room) : [title], usual = lines.length > 1 ? 13 : 14;
  const x = 0.5 * (frame.left + frame.right), base = frame.top - gaps.title - 16 * (lines.length - 1);
  return lines.map((text, i) => (
    {piece: "text", x, y: base + 16 * i, text, size: fittedSize(text, usual, room), color: theme.ink, anchor: "middle"}));
}

function clipped({left, top, right, bottom}: Frame, pieces: Piece[]): Piece[] {
  return pieces.length === 0 ? [] : [{piece: "clipped", x: left - 0.8, y: top - 0.8, width: right - left + 1.6, height: bottom - top + 1.6, pieces}];
}

/** Clips pieces to the frame, except for dots at its edge. */
function inFrame(frame: Frame, pieces: Piece[]): Piece[] {
  const layers: Piece[] = [];
  let open: Piece[] = [];
  for (const piece of pieces)
    if (piece.piece === "dots") {
      layers.push(...clipped(frame, open), piece);
      open = [];
    } else open.push(piece);
  return [...layers, ...clipped(frame, open)];
}

function barBeside({left, top, right, bottom}: Frame, aligned: boolean): Frame {
  const width = right - left, [from, to] = aligned ? [0.02, 0.055] : [0.025, 0.075];
  return {left: right + from * width, right: right + to * width, top, bottom};
}

function legendOf(plot: Plot, box: Box): LegendMark[][] {
  return plot.legend === "above" ? legendRows(entriesOf(plot), box[2] - 60) : entriesOf(plot).map((entry) => [entry]);
}

function planePanel(plot: Plot, box: Box, sheet: Sheet): Layers {
  const marks = plot.marks ?? [], floor = (log?: boolean) => (log ? 0 : -Infinity), {theme} = sheet;
  const x = scaleOf(plot.x ?? {}, extentOf(marks, "x", floor(plot.x?.log))), y = scaleOf(plot.y ?? {}, extentOf(marks, "y", floor(plot.y?.log)));
  const rows = legendOf(plot, box), above = plot.legend === "above" ? rows.length : 0;
  const letters = Math.max(0, ...rows.flat().map(({legend}) => [...legend].length));
  const frame = frameOf(plot, box, x, y, {aligned: sheet.aligned, anyColor: sheet.anyColor, legendRows: above, legendLetters: letters});
  const place = placeIn(frame, x, y), colors = colorsOf(plot);
  const drawing: Drawing = {theme, palette: colors.palette, figureWidth: sheet.width, frame, place: (row, i) => place(row.x?.[i], row.y?.[i])};
  const spans = marks.filter((mark): mark is SpanMark => mark.mark === "span").flatMap((mark) => spanPieces(mark, drawing, place));
  const axes = {plot, x, y, frame, theme};
  return {
    back: [...clipped(frame, spans), ...gridPieces(axes)],
    marks: inFrame(frame, marks.flatMap((mark) => markPieces(mark, drawing, place))),
    front: [
      ...axisPieces(axes), ...(colors.scale ? colorBar(colors.scale, colors.palette, barBeside(frame, sheet.aligned), theme) : []),
      ...legendPieces(plot, rows, drawing, frame.top - 16.2 - 40.5 * titleRows(plot.title ?? "") - 20.7 * (above - 1)), ...titlePieces(plot, box, frame, theme),
      ...textPieces(plot.texts ?? [], drawing, place),
    ],
  };
}

function markInSpace(mark: Mark, drawing: Drawing, space: ReturnType<typeof spaceOf>): Piece[] {
  if (mark.mark === "surface") return surfacePieces(mark, space, drawing);
  if (mark.mark === "line") return linePieces(mark, drawing);
  return mark.mark === "points" ? pointPieces(mark, drawing) : [];
}

function spacePanel(plot: Plot, box: Box, sheet: Sheet): Layers {
  const space = spaceOf(plot, box), colors = colorsOf(plot), {theme} = sheet;
  const frame = {left: box[0], top: box[1], right: box[0] + box[2], bottom: box[1] + box[3]};
  const drawing: Drawing = {theme, palette: colors.palette, figureWidth: sheet.width, frame, place: (row, i) => space.project(sharesOf(space, row, i)),
    depth: (row, i) => space.depth(sharesOf(space, row, i))};
  const rows = legendOf(plot, box);
  return {
    back: boxPieces(space, theme),
    marks: (plot.marks ?? []).flatMap((mark) => markInSpace(mark, drawing, space)),
    front: [
      ...spaceTexts(space, theme), ...(colors.scale ? colorBar(colors.scale, colors.palette, barInSpace(box), theme) : []),
      ...legendPieces(plot, rows, drawing, box[1] + 24), ...titlePieces(plot, box, {...frame, top: box[1] + 50}, theme),
      ...textPieces(plot.texts ?? [], drawing, (x, y) => space.project(sharesOf(space, {x: [x], y: [y], z: [space.scales[2].low]}, 0))),
    ],
  };
}

export const plotLayers = (plot: Plot, box: Box, sheet: Sheet): Layers => (plot.view ? spacePanel : planePanel)(plot, box, sheet);

/** Returns the title of a whole figure. */
export function figureTitle(title: string, {width, theme}: Sheet): Piece[] {
  if (title === "") return [];
  return [{piece: "text", x: 0.5 * width, y: 22.5, text: title, size: fittedSize(title, 15, width - 20), color: textColor("#111111", theme), anchor: "middle"}];
}
