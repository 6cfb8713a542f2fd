// Curves on a canvas. Values are SI; a plane says which stretch of them lies where.

import {paintPixels} from "./paint_pixels";
import {isEvery, rowsWithin, type Samples} from "./samples";
import type {Range} from "./y_range";

/** A rectangle of a canvas in its own pixels, and what it shows from left to right and from bottom to top. */
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
  /** Pixels of the canvas in one of the page. */
  ratio: number;
}

export const xOf = ({left, width, x}: Plane, value: number): number => left + ((value - x.low) / (x.high - x.low)) * width;
export const yOf = ({top, height, y}: Plane, value: number): number => top + height - ((value - y.low) / (y.high - y.low)) * height;

type Context = CanvasRenderingContext2D;

/** So many rows in a pixel are painted pixel by pixel. */
const dense = 0.6;

/** A curve over time. Where there is more than one row in a pixel, all that the pixel's rows reached is covered, so no peak is lost. */
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

/** Width 1 and no dashes where it is dense: what would be left out between dashes could be a peak. */
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

/** One vertical stroke for each row, from the end that is nearer to where the last one ended. */
function coverRows(context: Context, {time, low, high}: Samples, plane: Plane, from: number, to: number): void {
  let last = NaN;
  for (let row = from; row < to; ++row) last = cover(context, xOf(plane, time[row]), yOf(plane, low[row]), yOf(plane, high[row]), last);
}

/** At least a pixel high, so that a level stretch is seen. Returns where the pen is; NaN where it was lifted. */
function cover(context: Context, x: number, low: number, high: number, last: number): number {
  if (Number.isNaN(low + high)) return NaN;
  const [first, second] = Math.abs(last - low) <= Math.abs(last - high) ? [low, high] : [high, low];
  if (Number.isNaN(last)) context.moveTo(x, first);
  else context.lineTo(x, first);
  context.lineTo(x, second === first ? first + 0.01 : second);
  return second;
}

/** One signal against another; where only extremes are known, the rectangle in which they were. */
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
