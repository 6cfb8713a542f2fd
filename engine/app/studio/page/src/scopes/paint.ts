// Curves on a canvas. Values are SI; a plane maps them to pixels.

import {paintPixels} from "./paint_pixels";
import {isEvery, rowsWithin, type Samples} from "./samples";
import type {Range} from "./y_range";

/** Rectangle of a canvas in canvas pixels, with its horizontal and vertical ranges of values. */
export interface Plane {
  left: number;
  top: number;
  width: number;
  height: number;
  x: Range;
  y: Range;
}

export interface Stroke {
  color: string;
  dash: number[];
  alpha: number;
  /** Canvas pixels per page pixel. */
  ratio: number;
}

export const xOf = ({left, width, x}: Plane, value: number): number => left + ((value - x.low) / (x.high - x.low)) * width;
export const yOf = ({top, height, y}: Plane, value: number): number => top + height - ((value - y.low) / (y.high - y.low)) * height;

type Context = CanvasRenderingContext2D;

/** Rows per pixel above which a curve is painted pixel by pixel. */
const dense = 0.6;

/** Paints a curve over time. With several rows per pixel it covers the range of each pixel's rows, so that no peak is lost. */
export function paintOverTime(context: Context, samples: Samples, plane: Plane, stroke: Stroke): void {
  const {from, to} = rowsWithin(samples.time, plane.x), isDense = !isEvery(samples) || to - from > plane.width;
  if (to <= from) return;
  prepare(context, stroke, isDense);
  if (isDense && rowsInPixel(samples, plane, from, to) > dense) return paintPixels(context, samples, plane, from, to, stroke.ratio);
  context.beginPath();
  if (isDense) coverRows(context, samples, plane, from, to);
  else joinRows(context, samples, plane, from, to);
  context.stroke();
  if (to - from === 1) dot(context, xOf(plane, samples.time[from]), yOf(plane, samples.high[from]), 2 * stroke.ratio, stroke.color);
}

function rowsInPixel({time}: Samples, plane: Plane, from: number, to: number): number {
  return (to - from) / Math.max(1, xOf(plane, time[to - 1]) - xOf(plane, time[from]));
}

/** Sets the stroke style. A dense curve has width 1 and no dashes, since a gap between dashes could hide a peak. */
function prepare(context: Context, {color, dash, alpha, ratio}: Stroke, isDense: boolean): void {
  context.strokeStyle = context.fillStyle = color;
  context.lineWidth = (isDense ? 1 : 1.5) * ratio;
  context.lineJoin = "bevel";
  context.globalAlpha = isDense && dash.length > 0 ? 0.6 * alpha : alpha;
  context.setLineDash(isDense ? [] : dash.map((length) => length * ratio));
}

function joinRows(context: Context, {time, high}: Samples, plane: Plane, from: number, to: number): void {
  let isDown = false;
  for (let row = from; row < to; ++row) {
    const y = yOf(plane, high[row]);
    if (Number.isNaN(y)) isDown = false;
    else if (isDown) context.lineTo(xOf(plane, time[row]), y);
    else context.moveTo(xOf(plane, time[row]), y);
    isDown = !Number.isNaN(y);
  }
}

/** Adds one vertical stroke per row, starting at the end that is nearer to the end of the last one. */
function coverRows(context: Context, {time, low, high}: Samples, plane: Plane, from: number, to: number): void {
  let last = NaN;
  for (let row = from; row < to; ++row) last = cover(context, xOf(plane, time[row]), yOf(plane, low[row]), yOf(plane, high[row]), last);
}

/** Adds a stroke of at least one pixel, so that a constant is visible. Returns the position of the pen; NaN after a gap. */
function cover(context: Context, x: number, low: number, high: number, last: number): number {
  if (Number.isNaN(low + high)) return NaN;
  const [first, second] = Math.abs(last - low) <= Math.abs(last - high) ? [low, high] : [high, low];
  if (Number.isNaN(last)) context.moveTo(x, first);
  else context.lineTo(x, first);
  context.lineTo(x, second === first ? first + 0.01 : second);
  return second;
}

/** Paints one signal against another; for extremes, the rectangles that contain the values. */
export function paintAgainst(context: Context, xs: Samples, ys: Samples, plane: Plane, stroke: Stroke, window: Range): void {
  const {from, to} = rowsWithin(xs.time, window);
  if (isEvery(xs) && isEvery(ys)) {
    prepare(context, stroke, false);
    context.beginPath();
    joinRows(context, {time: xs.high, low: ys.low, high: ys.high}, plane, from, to);
    context.stroke();
    return;
  }
  context.fillStyle = stroke.color;
  context.globalAlpha = stroke.alpha;
  for (let row = from; row < to; ++row) rectangle(context, xs, ys, plane, row, stroke.ratio);
}

function rectangle(context: Context, xs: Samples, ys: Samples, plane: Plane, row: number, least: number): void {
  const x = xOf(plane, xs.low[row]), y = yOf(plane, ys.high[row]);
  context.fillRect(x, y, Math.max(least, xOf(plane, xs.high[row]) - x), Math.max(least, yOf(plane, ys.low[row]) - y));
}

export function dot(context: Context, x: number, y: number, radius: number, color: string): void {
  context.fillStyle = color;
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.fill();
}
