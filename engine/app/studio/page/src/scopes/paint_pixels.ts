// Curves with about a row in each pixel or more: what each pixel's rows reached, as a smooth line where it is one, else as bars.

import type {Plane} from "./paint";
import type {Samples} from "./samples";

/** What the rows of each pixel reached, from left to right; pixels without rows are left out. Filled anew for each curve. */
const pixels = {count: 0, x: new Float64Array(0), top: new Float64Array(0), bottom: new Float64Array(0)};

/** A line of this share of bars or more is drawn of bars alone. */
const rough = 0.3;
/** Pixels without rows that are drawn across: rows may be a little wider than a pixel. */
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
    const pixel = Math.floor(left + time[row] * across);
    let least = Infinity, most = -Infinity;
    for (; row < to && left + time[row] * across < pixel + 1; ++row) {
      if (low[row] < least) least = low[row];
      if (high[row] > most) most = high[row];
    }
    if (!(least <= most)) continue;
    pixels.x[pixels.count] = pixel;
    pixels.top[pixels.count] = bottom - most * up;
    pixels.bottom[pixels.count++] = bottom - least * up;
  }
}

function makeRoom(count: number): void {
  if (pixels.x.length >= count) return;
  pixels.x = new Float64Array(2 * count);
  pixels.top = new Float64Array(2 * count);
  pixels.bottom = new Float64Array(2 * count);
}

const middle = (i: number): number => (pixels.top[i] + pixels.bottom[i]) / 2;
const isNext = (i: number): boolean => i > 0 && pixels.x[i] - pixels.x[i - 1] <= bridged;

/** Did the rows of a pixel reach what a line from middle to middle does not cover? */
function sticksOut(i: number, ratio: number): boolean {
  const own = middle(i), before = isNext(i) ? (own + middle(i - 1)) / 2 : own, after = i + 1 < pixels.count ? (own + middle(i + 1)) / 2 : own;
  const slack = 0.75 * ratio;
  return pixels.top[i] < Math.min(own, before, after) - slack || pixels.bottom[i] > Math.max(own, before, after) + slack;
}

/** A line through the middles; where a pixel reached farther, a bar, through which the line goes on at its height. */
function paintLine(context: CanvasRenderingContext2D, ratio: number): void {
  context.lineWidth = 1.5 * ratio;
  context.beginPath();
  let last = NaN;
  for (let i = 0; i < pixels.count; ++i) {
    const isBar = sticksOut(i, ratio), y = isBar && isNext(i) ? Math.min(pixels.bottom[i], Math.max(pixels.top[i], last)) : middle(i);
    if (isNext(i)) context.lineTo(pixels.x[i] + 0.5, y);
    else context.moveTo(pixels.x[i] + 0.5, y);
    if (isBar) context.fillRect(pixels.x[i], pixels.top[i] - 0.5 * ratio, 1, pixels.bottom[i] - pixels.top[i] + ratio);
    last = y;
  }
  context.stroke();
}

/** A bar for each pixel, on to where the pixel before ended, so that the curve has no gaps. */
function paintBars(context: CanvasRenderingContext2D): void {
  const half = context.lineWidth / 2, {x, top, bottom} = pixels;
  for (let i = 0; i < pixels.count; ++i) {
    const isOn = isNext(i), begin = isOn ? x[i - 1] + 1 : x[i];
    const high = isOn && bottom[i - 1] < top[i] ? bottom[i - 1] : top[i], low = isOn && top[i - 1] > bottom[i] ? top[i - 1] : bottom[i];
    context.fillRect(begin, high - half, x[i] + 1 - begin, low - high + 2 * half);
  }
}
