// Grid, frame, ticks and labels of plane axes, and the colour bar.

import type {Scale} from "./axis";
import type {Palette, Theme} from "./colors";
import {barLabelGap, depthOfTicks, type Frame, gaps, yLabelGap} from "./layout";
import type {PathPiece, Piece, TextPiece} from "./pieces";
import type {Plot} from "./spec";
import {fittedSize, textWidth} from "./text_size";

const letterSize = 13;

interface Axes {
  plot: Plot;
  x: Scale;
  y: Scale;
  frame: Frame;
  theme: Theme;
}

const xAt = (scale: Scale, {left, right}: Frame, value: number) => left + scale.share(value) * (right - left);
const yAt = (scale: Scale, {top, bottom}: Frame, value: number) => bottom - scale.share(value) * (bottom - top);

const strokes = (lines: number[][], color: string, width: number): PathPiece[] => (lines.length ? [{piece: "path", lines, stroke: {color, width}}] : []);

/** Returns the pieces behind all marks. */
export function gridPieces({plot, x, y, frame, theme}: Axes): Piece[] {
  const lines: number[][] = [];
  if (plot.x?.grid !== false) for (const {at} of x.ticks) lines.push([xAt(x, frame, at), frame.top, xAt(x, frame, at), frame.bottom]);
  if (plot.y?.grid !== false) for (const {at} of y.ticks) lines.push([frame.left, yAt(y, frame, at), frame.right, yAt(y, frame, at)]);
  return [...strokes(lines, theme.grid, 1), ...zeroLines({plot, x, y, frame, theme})];
}

function zeroLines({plot, x, y, frame, theme}: Axes): Piece[] {
  const lines: number[][] = [], inside = (share: number) => share >= 0 && share <= 1;
  if (plot.x?.zero_line && inside(y.share(0))) lines.push([frame.left, yAt(y, frame, 0), frame.right, yAt(y, frame, 0)]);
  if (plot.y?.zero_line && inside(x.share(0))) lines.push([xAt(x, frame, 0), frame.top, xAt(x, frame, 0), frame.bottom]);
  return strokes(lines, theme.frame, 1);
}

function border({plot, frame: {left, top, right, bottom}}: Axes): number[][] {
  if (plot.closed_frame) return [[left, top, right, top, right, bottom, left, bottom, left, top]];
  const lines: number[][] = [];
  if (plot.x?.line !== false) lines.push([left, bottom, right, bottom]);
  if (plot.y?.line !== false) lines.push([left, top, left, bottom]);
  return lines;
}

function tickLines({plot, x, y, frame}: Axes): number[][] {
  const lines: number[][] = [];
  const below = (at: number, length: number) => lines.push([xAt(x, frame, at), frame.bottom, xAt(x, frame, at), frame.bottom + length]);
  const aside = (at: number, length: number) => lines.push([frame.left, yAt(y, frame, at), frame.left - length, yAt(y, frame, at)]);
  if (plot.x?.tick_marks !== false) {
    for (const {at} of x.ticks) below(at, gaps.tick);
    for (const at of x.minor) below(at, 0.5 * gaps.tick);
  }
  if (plot.y?.tick_marks !== false) {
    for (const {at} of y.ticks) aside(at, gaps.tick);
    for (const at of y.minor) aside(at, 0.5 * gaps.tick);
  }
  return lines;
}

/** Returns the labels below the frame. A label that would touch the previous one is omitted unless it is a name. */
function xTickTexts({plot, x, frame, theme}: Axes): TextPiece[] {
  const angle = plot.x?.label_angle ?? 0, named = plot.x?.named_ticks !== undefined;
  let free = -Infinity;
  const texts: TextPiece[] = [];
  for (const {at, label} of x.ticks) {
    const middle = xAt(x, frame, at), half = 0.5 * textWidth(label, letterSize);
    if (!named && angle === 0 && middle - half < free) continue;
    free = middle + half + 3;
    const y = frame.bottom + (angle === 0 ? gaps.tickBase : 20);
    texts.push({piece: "text", x: middle, y, text: label, size: letterSize, color: theme.ticks, anchor: angle === 0 ? "middle" : angle > 0 ? "end" : "start", angle: -angle});
  }
  return texts;
}

const yTickTexts = ({y, frame, theme}: Axes): TextPiece[] =>
  y.ticks.map(({at, label}) => ({piece: "text", x: frame.left - gaps.tickLabel, y: yAt(y, frame, at) + gaps.base, text: label, size: letterSize, color: theme.ticks, anchor: "end"}));

function upright(text: string, x: number, {top, bottom}: Frame, color: string): TextPiece[] {
  if (text === "") return [];
  const size = fittedSize(text, letterSize, bottom - top + 60);
  return [{piece: "text", x, y: 0.5 * (top + bottom), text, size, color, anchor: "middle", angle: -90}];
}

function labels(axes: Axes): TextPiece[] {
  const {x, y, frame, theme} = axes, turned = Math.max(0, depthOfTicks(x) - letterSize);
  const below: TextPiece[] = x.label === "" ? [] : [{
    piece: "text", x: 0.5 * (frame.left + frame.right), y: frame.bottom + (x.ticks.length === 0 ? 29 : gaps.xLabel) + turned, text: x.label,
    size: fittedSize(x.label, letterSize, frame.right - frame.left + 80), color: theme.ink, anchor: "middle",
  }];
  return [...below, ...upright(y.label, frame.left - yLabelGap(y), frame, theme.ink)];
}

/** Returns the pieces in front of the marks. */
export function axisPieces(axes: Axes): Piece[] {
  return [...strokes([...border(axes), ...tickLines(axes)], axes.theme.frame, 0.8), ...xTickTexts(axes), ...yTickTexts(axes), ...labels(axes)];
}

/** Returns the colour bar in its rectangle beside a frame. */
export function colorBar(color: Scale, palette: Palette, bar: Frame, theme: Theme): Piece[] {
  const height = (bar.bottom - bar.top) / palette.all.length, pieces: Piece[] = [];
  palette.all.forEach((fill, i) => {
    const low = bar.bottom - i * height, high = Math.max(bar.top, low - height - 0.6);
    pieces.push({piece: "path", lines: [[bar.left, low, bar.right, low, bar.right, high, bar.left, high]], closed: true, fill});
  });
  const lines = color.ticks.map(({at}) => [bar.right, yAt(color, bar, at), bar.right + gaps.tick, yAt(color, bar, at)]);
  const texts: TextPiece[] = color.ticks.map(({at, label}) => (
    {piece: "text", x: bar.right + gaps.tickLabel, y: yAt(color, bar, at) + gaps.base, text: label, size: letterSize, color: theme.ticks, anchor: "start"}));
  return [...pieces, ...strokes(lines, theme.frame, 0.8), ...texts, ...upright(color.label, bar.right + barLabelGap(color), bar, theme.ink)];
}
