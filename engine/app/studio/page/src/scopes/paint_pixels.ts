// Curves with one row per pixel or more: the range of each pixel's rows, as a smooth line if possible, else as bars.

import type {Plane} from "./paint";
import type {Samples} from "./samples";

/**
 * Ranges of the rows of each pixel, from left to right, without empty pixels; reused for each curve. `x` is the pixel, `at` the centre of
 * its rows, `first` and `last` their ends. Pixels have one row or two alternately, so a line through pixel centres would have steps.
 */
const pixels = {count: 0, x: new Float64Array(0), at: new Float64Array(0), first: new Float64Array(0), last: new Float64Array(0), top: new Float64Array(0), bottom: new Float64Array(0)};

/** Share of protruding pixels above which the curve is drawn as bars. */
const rough = 0.3;
/** Number of empty pixels that a line bridges: rows may be slightly wider than a pixel. */
const bridged = 3;

export function paintPixels(context: CanvasRenderingContext2D, samples: Samples, plane: Plane, from: number, to: number, ratio: number): void {
  gather(samples, plane, from, to);
  let bars = 0;
  for (let i = 0; i < pixels.count; ++i) if (sticksOut(i, ratio)) ++bars;
  if (bars > rough * pixels.count) return paintBars(context);
  paintLine(context, ratio);
}

function gather({time, low, high}: Samples, plane: Plane, from: number, to: number): void {
  const across = plane.width / (plane.x.high - plane.x.low), up = plane.height / (plane.y.high - plane.y.low);
  const left = plane.left - plane.x.low * across, bottom = plane.top + plane.height + plane.y.low * up;
  makeRoom(to - from);
  pixels.count = 0;
  for (let row = from; row < to;) {
    const first = left + time[row] * across, pixel = Math.floor(first);
    let least = Infinity, most = -Infinity;
    for (; row < to && left + time[row] * across < pixel + 1; ++row) {
      if (low[row] < least) least = low[row];
      if (high[row] > most) most = high[row];
    }
    if (!(least <= most)) continue;
    const last = left + time[row - 1] * across;
    pixels.x[pixels.count] = pixel;
    pixels.at[pixels.count] = (first + last) / 2;
    pixels.first[pixels.count] = first;
    pixels.last[pixels.count] = last;
    pixels.top[pixels.count] = bottom - most * up;
    pixels.bottom[pixels.count++] = bottom - least * up;
  }
}

function makeRoom(count: number): void {
  if (pixels.x.length >= count) return;
  for (const key of ["x", "at", "first", "last", "top", "bottom"] as const) pixels[key] = new Float64Array(2 * count);
}

const middle = (i: number): number => (pixels.top[i] + pixels.bottom[i]) / 2;
const isNext = (i: number): boolean => i > 0 && i < pixels.count && pixels.x[i] - pixels.x[i - 1] <= bridged;

/** Returns the height of the line from pixel `i - 1` to pixel `i`, half-way between their rows. */
function between(i: number): number {
  const {at, first, last} = pixels, share = ((last[i - 1] + first[i]) / 2 - at[i - 1]) / (at[i] - at[i - 1]);
  return middle(i - 1) + share * (middle(i) - middle(i - 1));
}

/** True if the range of a pixel exceeds the part that a line through the middles covers. */
function sticksOut(i: number, ratio: number): boolean {
  const own = middle(i), hasBefore = isNext(i), hasAfter = isNext(i + 1);
  const after = hasAfter ? between(i + 1) : hasBefore ? 2 * own - between(i) : own, before = hasBefore ? between(i) : 2 * own - after;  // an end continues in the same direction
  const slack = 0.75 * ratio;
  return pixels.top[i] < Math.min(own, before, after) - slack || pixels.bottom[i] > Math.max(own, before, after) + slack;
}

/**
 * Paints a line through the middles. Where the range of a pixel exceeds the line, it also covers the range, from the end nearer to the last
 * pixel.
 */
function paintLine(context: CanvasRenderingContext2D, ratio: number): void {
  context.beginPath();
  for (let i = 0, last = NaN; i < pixels.count; ++i) {
    const x = pixels.at[i], own = middle(i), [first, second] = sticksOut(i, ratio) ? endsFrom(i, last) : [own, own];
    if (isNext(i)) context.lineTo(x, first);
    else context.moveTo(x, first);
    if (second !== first) context.lineTo(x, second);
    last = second !== first && isNext(i + 1) ? towards(i, i + 1) : second;
    if (last !== second) context.lineTo(x, last);
  }
  if (ratio > 1) context.lineWidth = 1.5 * ratio;
  context.stroke();
  if (ratio <= 1 && context.globalAlpha === 1) widen(context);
}

/** Widens a line by half a pixel, by strokes of width 1; without a graphics card each takes a tenth of the time of a wider one. */
function widen(context: CanvasRenderingContext2D): void {
  for (const [right, down] of [[0.5, 0], [-0.5, 0.5]]) {
    context.translate(right, down);
    context.stroke();
  }
  context.translate(0, -0.5);
}

/** Returns both ends of a pixel's range, the one nearer to `last` first. */
function endsFrom(i: number, last: number): [number, number] {
  const {top, bottom} = pixels;
  return Math.abs(last - bottom[i]) < Math.abs(last - top[i]) ? [bottom[i], top[i]] : [top[i], bottom[i]];
}

/** Returns the value in the range of pixel `i` that is nearest to the middle of another pixel. */
const towards = (i: number, other: number): number => Math.min(pixels.bottom[i], Math.max(pixels.top[i], middle(other)));

/**
 * Paints a bar for each pixel, extended to the end of the previous one so that the curve has no gaps. The bars are strokes of one path, one
 * pixel wide: without a graphics card that takes a tenth of the time of filled rectangles.
 */
function paintBars(context: CanvasRenderingContext2D): void {
  const half = context.lineWidth / 2, {x, top, bottom} = pixels;
  context.lineWidth = 1;
  context.beginPath();
  for (let i = 0; i < pixels.count; ++i) {
    const isOn = isNext(i), high = (isOn && bottom[i - 1] < top[i] ? bottom[i - 1] : top[i]) - half, low = (isOn && top[i - 1] > bottom[i] ? top[i - 1] : bottom[i]) + half;
    for (let at = isOn ? x[i - 1] + 1 : x[i]; at <= x[i]; ++at) {
      context.moveTo(at + 0.5, high);
      context.lineTo(at + 0.5, low);
    }
  }
  context.stroke();
}
