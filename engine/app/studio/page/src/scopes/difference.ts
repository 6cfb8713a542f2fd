import type {DisplayUnit} from "./display_unit";
import {numberText, quantityText} from "./numbers";
import {isEvery, nearestRow, rowFrom, type Samples} from "./samples";

/** Difference of a run to a pinned one; SI, times in s. */
export interface Difference {
  samples: Samples;
  /** Largest magnitude, and its time. */
  worst: number;
  at: number;
  /** Share of time beyond the tolerance, and the first such time; undefined if there is none. */
  share: number;
  first: number | undefined;
}

/** Interpolates linearly between rows; NaN outside of them. */
function valueBetween(time: Float64Array, values: Float64Array, at: number): number {
  const row = rowFrom(time, at);
  if (row === time.length) return NaN;
  if (time[row] === at) return values[row];
  if (row === 0) return NaN;
  const share = (at - time[row - 1]) / (time[row] - time[row - 1]);
  return values[row - 1] + share * (values[row] - values[row - 1]);
}

type Pair = {low: number; high: number};

/** Returns the range of `now` minus `before` in a row of `now`. */
function pairAt(now: Samples, before: Samples, row: number): Pair {
  const at = now.time[row];
  if (isEvery(now) && isEvery(before)) {
    const value = now.low[row] - valueBetween(before.time, before.low, at);
    return {low: value, high: value};
  }
  const other = nearestRow(before.time, at), isSame = before.time[other] === at && isEvery(now) === isEvery(before);
  if (other < 0 || at > before.time[before.time.length - 1] + (before.time[1] - before.time[0])) return {low: NaN, high: NaN};
  const a = now.low[row] - before.low[other], b = now.high[row] - before.high[other];
  return isSame ? {low: Math.min(a, b), high: Math.max(a, b)} : gap(now.low[row] - before.high[other], now.high[row] - before.low[other]);
}

/** Returns the gap between two ranges. Intervals with different sampling are only known to differ by that much. */
function gap(above: number, below: number): Pair {
  const value = above > 0 ? above : below < 0 ? below : 0;
  return {low: value, high: value};
}

/**
 * Returns `now` minus `before` at the times of `now`. Minima are compared with minima and maxima with maxima, so that equal runs have no
 * difference.
 */
export function difference(now: Samples, before: Samples, tolerance: number): Difference {
  const rows = now.time.length, low = new Float64Array(rows), high = new Float64Array(rows);
  const result: Difference = {samples: {time: now.time, low, high}, worst: 0, at: NaN, share: 0, first: undefined};
  let known = 0, beyond = 0;
  for (let row = 0; row < rows; ++row) {
    const pair = pairAt(now, before, row), size = Math.max(Math.abs(pair.low), Math.abs(pair.high));
    low[row] = pair.low;
    high[row] = pair.high;
    if (Number.isNaN(size)) continue;
    ++known;
    if (size > result.worst || Number.isNaN(result.at)) Object.assign(result, {worst: size, at: now.time[row]});
    if (!(size > tolerance)) continue;
    ++beyond;
    result.first ??= now.time[row];
  }
  result.share = known > 0 ? beyond / known : 0;
  return result;
}

/** Parses a tolerance into SI: "0.1" and "0.1 mm" in the display unit, "1 %" of `span` [SI]. Undefined for other texts. */
export function readTolerance(text: string, unit: DisplayUnit, span: number): number | undefined {
  const match = /^\s*([\d.]+(?:e[-+]?\d+)?)\s*(.*?)\s*$/i.exec(text), value = Number(match?.[1]);
  if (!match || !(value >= 0)) return undefined;
  if (match[2] === "%") return (value / 100) * span;
  return match[2] === "" || match[2] === unit.text ? value / unit.scale : undefined;
}

/** Returns "largest difference 0.31 mm at 1.234 s; beyond 0.1 mm in 12 % of the time, first at 1.2 s". */
export function differenceText({worst, at, share, first}: Difference, tolerance: number, unit: DisplayUnit): string {
  if (Number.isNaN(at)) return "the runs have no time in common";
  const largest = `largest difference ${quantityText(worst * unit.scale, unit.text)} at ${quantityText(at, "s")}`;
  const bound = quantityText(tolerance * unit.scale, unit.text);
  if (first === undefined) return `${largest}; within ${bound}`;
  return `${largest}; beyond ${bound} in ${numberText(100 * share, 2)} % of the time, first at ${quantityText(first, "s")}`;
}
